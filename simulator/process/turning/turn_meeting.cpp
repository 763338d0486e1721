#include "simulator/process/turning/turn_meeting.h"

namespace limitgauge::simulator {

bool TurnMeeting::worse_than(const TurnMeeting& other) const {
  if (touch != other.touch) return touch > other.touch;
  if (!place || !other.place) return place && !other.place;
  return touch == Touch::none ? place->mm < other.place->mm : place->mm > other.place->mm;
}

/// The first look is only sure of what is half as deep again as its tolerance.
TurnMeeting contact_during(const TurnSearch& search, double tolerance_mm,
                           const model::RunControl& control) {
  const TurnAnswer sure = deepest_turn_contact(search, tolerance_mm, control);
  if (sure.place || !sure.proven) return {Touch::contact, sure.place};
  TurnSearch finer = search;
  finer.most_looks = kMostSlightLooks;
  const TurnAnswer slight = deepest_turn_contact(finer, tolerance_mm / 10, control);
  if (!slight.place) return {};
  return {slight.place->mm > tolerance_mm ? Touch::contact : Touch::slight, slight.place};
}

TurnMeeting gap_during(const TurnSearch& search, double within_mm, double tolerance_mm,
                       const model::RunControl& control) {
  TurnSearch limited = search;
  limited.most_looks = kMostSlightLooks;
  return {Touch::none, least_turn_gap(limited, within_mm, tolerance_mm, control).place};
}

}  // namespace limitgauge::simulator
