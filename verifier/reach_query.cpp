#include "verifier/reach_query.h"

namespace limitgauge::verifier {

using model::Vec3;

bool ReachQuery::can_be_touched(const SurfacePlace& place, const Vec3& normal) const {
  switch (proven_.at(place.patch, place.u, place.v)) {
    case Reach::reachable:
      return true;
    case Reach::unreachable:
      return false;
    case Reach::undecided:
      break;
  }
  return search_.touching_tip(place.point, normal).has_value();
}

std::optional<Vec3> ReachQuery::touching_tip(const SurfacePlace& place, const Vec3& normal) const {
  const Reach proven = proven_.at(place.patch, place.u, place.v);
  if (proven == Reach::unreachable) return std::nullopt;
  if (proven == Reach::reachable)
    if (const auto tip = search_.contact_tip(place.point, normal)) return tip;
  return search_.touching_tip(place.point, normal);
}

bool ReachQuery::surely_unreachable(const SurfaceCell& cell) const {
  switch (proven_.of(cell)) {
    case Reach::reachable:
      return false;
    case Reach::unreachable:
      return true;
    case Reach::undecided:
      break;
  }
  return search_.surely_unreachable(cell.shape);
}

}  // namespace limitgauge::verifier
