#include "engine/strategy/linking/link_fan.h"

namespace limitgauge::engine::strategy {
namespace {

double slope_between(const PlanePoint& a, const PlanePoint& b) {
  return (b.z - a.z) / (b.s - a.s);
}

}  // namespace

/// The point touched only moves on, since points come from left to right. A point at the s of `p`
/// bounds nothing on its left.
std::optional<double> LinkFan::tangent(Chain& chain, const PlanePoint& p, double side) {
  std::size_t count = chain.points.size();
  if (count > 0 && chain.points.back().s == p.s) --count;
  if (count == 0) return std::nullopt;
  double slope = slope_between(chain.points[chain.touched], p);
  while (chain.touched + 1 < count) {
    const double next = slope_between(chain.points[chain.touched + 1], p);
    if (side * (next - slope) > 0) break;
    slope = next;
    ++chain.touched;
  }
  return slope;
}

/// Keeps the chain convex towards the lines (side 1: upper points, from below); what lies before
/// the point touched is done with.
void LinkFan::append(Chain& chain, const PlanePoint& p, double side) {
  std::vector<PlanePoint>& points = chain.points;
  while (points.size() >= chain.touched + 2) {
    const PlanePoint &a = points[points.size() - 2], &b = points.back();
    const double turn = (b.s - a.s) * (p.z - a.z) - (b.z - a.z) * (p.s - a.s);
    if (side * turn > 0) break;
    points.pop_back();
  }
  points.push_back(p);
}

void LinkFan::add_upper(const PlanePoint& p) {
  if (!steepest_ || p.z < steepest_->height(p.s))
    if (const auto slope = tangent(lowers_, p, 1)) {
      steepest_ = Line{p, *slope};
      last_upper_ = p;
    }
  append(uppers_, p, 1);
}

void LinkFan::add_lower(const PlanePoint& p) {
  if (!least_ || p.z > least_->height(p.s))
    if (const auto slope = tangent(uppers_, p, -1)) {
      least_ = Line{p, *slope};
      last_lower_ = p;
    }
  append(lowers_, p, -1);
}

std::optional<LinkFan::Turn> LinkFan::misses(const PlanePoint& upper,
                                             const PlanePoint& lower) const {
  if (steepest_ && lower.z > steepest_->height(lower.s)) return Turn::up;
  if (least_ && upper.z < least_->height(upper.s)) return Turn::down;
  return std::nullopt;
}

Line LinkFan::middle() const {
  if (!steepest_ || !least_) return steepest_ ? *steepest_ : *least_;
  const double s = steepest_->at.s;
  return {{s, (steepest_->at.z + least_->height(s)) / 2}, (steepest_->slope + least_->slope) / 2};
}

}  // namespace limitgauge::engine::strategy
