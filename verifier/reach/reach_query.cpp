#include "verifier/reach/reach_query.h"

#include <algorithm>

namespace limitgauge::verifier {

using model::Vec3;

namespace {

std::optional<Vec3> touching_tip(const Reachability& search, const Vec3& p, const Vec3& normal,
                                 NormalOf of) {
  const model::Pose& own = search.to_own();
  return search.touching_tip(own.point(p), own.direction(normal), of);
}

bool any_touches(std::span<const Reachability> searches, const Vec3& p, const Vec3& normal,
                 NormalOf of) {
  return std::any_of(searches.begin(), searches.end(), [&](const Reachability& search) {
    return touching_tip(search, p, normal, of).has_value();
  });
}

std::optional<Vec3> contact_tip(const Reachability& search, const Vec3& p, const Vec3& normal) {
  const model::Pose& own = search.to_own();
  return search.contact_tip(own.point(p), own.direction(normal));
}

bool surely_unreachable_by(const Reachability& search, const OffsetCell& cell,
                           ContactMemory* memory, NormalOf of) {
  if (search.to_own() == model::Pose{}) return search.surely_unreachable(cell, memory, of);
  return search.surely_unreachable(turned(cell, search.to_own()), memory, of);
}

}  // namespace

bool ReachQuery::can_be_touched(const SurfacePlace& place, const Vec3& normal) const {
  switch (proven_.at(place.patch, place.u, place.v)) {
    case Reach::reachable:
      return true;
    case Reach::unreachable:
      return false;
    case Reach::undecided:
      break;
  }
  return any_touches(searches_, place.point, normal, NormalOf::face);
}

bool ReachQuery::ridge_can_be_touched(const Vec3& p, const Vec3& normal) const {
  return any_touches(searches_, p, normal, NormalOf::edge);
}

std::optional<ReachQuery::Touch> ReachQuery::touch(const SurfacePlace& place,
                                                   const Vec3& normal) const {
  const auto entry = proven_.entry_at(place.patch, place.u, place.v);
  if (entry && entry->reach == Reach::unreachable) return std::nullopt;
  if (entry && entry->reach == Reach::reachable)
    if (const auto tip = contact_tip(searches_[entry->cutter], place.point, normal))
      return Touch{entry->cutter, *tip};
  for (std::size_t k = 0; k < searches_.size(); ++k)
    if (const auto tip = touching_tip(searches_[k], place.point, normal, NormalOf::face))
      return Touch{k, *tip};
  return std::nullopt;
}

bool ReachQuery::surely_unreachable(const SurfaceCell& cell, const OffsetCell& offset,
                                    ReachMemory* memory) const {
  switch (proven_.of(cell)) {
    case Reach::reachable:
      return false;
    case Reach::unreachable:
      return true;
    case Reach::undecided:
      break;
  }
  return surely_unreachable(offset, memory);
}

bool ReachQuery::any_is_mapped() const {
  return std::any_of(searches_.begin(), searches_.end(),
                     [](const Reachability& search) { return !search.profile().is_pointed(); });
}

bool ReachQuery::may_prove_unreachable() const {
  return std::all_of(searches_.begin(), searches_.end(),
                     [](const Reachability& search) { return search.may_prove_unreachable(); });
}

bool ReachQuery::surely_unreachable(const OffsetCell& piece, ReachMemory* memory,
                                    NormalOf of) const {
  if (memory) memory->resize(searches_.size());
  for (std::size_t k = 0; k < searches_.size(); ++k)
    if (!surely_unreachable_by(searches_[k], piece, memory ? &(*memory)[k] : nullptr, of))
      return false;
  return true;
}

}  // namespace limitgauge::verifier
