#include "simulator/sweep/sweep_index.h"

#include <algorithm>

namespace limitgauge::simulator {

using model::Vec3;

SweepIndex::SweepIndex(const Pass& pass, const model::RunControl& control)
    : own_(pass, control),
      pose_(pass.pose),
      inverse_(pass.pose.inverse()),
      turned_(pass.pose != model::Pose{}),
      widening_(inverse_.widening()) {}

std::optional<NearestMove> SweepIndex::nearest(const Vec3& p, double bound,
                                               std::uint32_t end) const {
  std::optional<NearestMove> found = own_.nearest(to_own(p), bound, end);
  if (found) found->at = from_own(found->at);
  return found;
}

// In the path's frame the block leans and lies in a box that is longer than it: what holds within
// the ball about the block may then be the tighter of the two.
double SweepIndex::outside_bound(std::uint32_t slot, const Vec3& p, const SweptSample& at,
                                 const Vec3& half) const {
  if (!turned_) return own_.outside_bound(slot, p, at, half);
  const Vec3 own = to_own(p);
  const SweptSample there{at.distance, pose_.direction_back(at.gradient), at.t};
  return std::min(own_.outside_bound(slot, own, there, inverse_.half(half)),
                  own_.curvature_bound(slot, own, there, length(half)));
}

}  // namespace limitgauge::simulator
