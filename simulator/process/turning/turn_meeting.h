#pragma once

#include <optional>

#include "simulator/process/turning/turn_search.h"

namespace limitgauge::simulator {

/// How a moving body meets a solid. A contact shallower than the tolerance but not than a tenth of
/// it is slight.
enum class Touch { none, slight, contact };

/// The deepest contact or the least distance, and when.
struct TurnMeeting {
  Touch touch = Touch::none;
  std::optional<TurnPlace> place;  ///< none of a contact that was not excluded

  /// Whether it is worse than what was before: of equal ones the first stays.
  bool worse_than(const TurnMeeting& other) const;
};

/// Of what does not fail anything, a search takes so many looks.
inline constexpr std::size_t kMostSlightLooks = kMostTurnLooks / 10;

/// Whether and how deeply the body touches. A contact deeper than one and a half tolerances is
/// never missed: where the search is given up it is one without a place. Throws Interrupted.
TurnMeeting contact_during(const TurnSearch& search, double tolerance_mm,
                           const model::RunControl& control);
/// What is left between, where that is less than `within_mm`. Throws Interrupted.
TurnMeeting gap_during(const TurnSearch& search, double within_mm, double tolerance_mm,
                       const model::RunControl& control);

}  // namespace limitgauge::simulator
