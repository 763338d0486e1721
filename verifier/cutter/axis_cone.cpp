#include "verifier/cutter/axis_cone.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "verifier/tolerance.h"

namespace limitgauge::verifier {
namespace {

using model::Box3;
using model::Vec3;

/// The longest way across `axis` to a corner of the box about zero.
double across_mm(const Vec3& half, const Vec3& axis) {
  const double square = model::length_squared(half);
  double least = square;  // of the squares along the axis
  for (const double x : {-half.x, half.x})
    for (const double y : {-half.y, half.y}) {
      const double along = x * axis.x + y * axis.y + half.z * axis.z;
      least = std::min(least, along * along);
    }
  return std::sqrt(square - least);
}

}  // namespace

AxisCone::AxisCone(const TurningBody& body)
    : axis_(body.axis(0.5)), spread_rad_(body.turn_rad() / 2) {}

AxisCone::AxisCone(std::span<const TurningBody> bodies) {
  Vec3 sum;
  for (const TurningBody& body : bodies) sum += body.axis(0.5);
  if (length(sum) < kCancels) return;
  axis_ = model::normalized(sum);
  for (const TurningBody& body : bodies)
    spread_rad_ =
        std::max(spread_rad_, model::angle_between(axis_, body.axis(0.5)) + body.turn_rad() / 2);
  if (spread_rad_ >= std::numbers::pi / 2) axis_ = {};
}

/// A profile that is turned about its core by an angle moves a place that is r from there by no
/// more than r times the angle.
double AxisCone::bound(const CutterProfile& profile, double size_mm, const Box3& cores,
                       const Vec3& p, const Vec3& half, double enough_mm) const {
  const Vec3 room = cores.size() / 2 + half, from = p - cores.centre();
  const double radius = length(room), far = length(from);
  const double by_size = far - radius - size_mm - kDistanceRounding_mm;
  if (axis_ == Vec3{} || by_size >= enough_mm) return by_size;
  const double along = dot(from, axis_);
  const double up =
      std::abs(axis_.x) * room.x + std::abs(axis_.y) * room.y + std::abs(axis_.z) * room.z;
  const double rho = std::max(0.0, length(from - axis_ * along) - across_mm(room, axis_));
  const double height = along + profile.core_mm;
  const double open = open_distance(profile, rho, height + up).value;
  const double standing = std::max(open, height - up - profile.top_mm);
  return std::max(by_size, standing - spread_rad_ * (far + radius) - kDistanceRounding_mm);
}

double farthest_from_core_mm(const CutterProfile& profile) {
  const double up = std::max(profile.top_mm - profile.core_mm, profile.core_mm - profile.tip_mm());
  return std::hypot(profile.largest_radius_mm(), up);
}

std::vector<AxisCone> axis_cones(const std::vector<model::BoxNode>& nodes,
                                 std::span<const TurningBody> bodies) {
  std::vector<AxisCone> cones(nodes.size());
  const auto ranges = model::element_ranges(nodes);
  for (std::size_t at = 0; at < nodes.size(); ++at) {
    const auto [first, last] = ranges[at];
    cones[at] = AxisCone(bodies.subspan(first, last - first));
  }
  return cones;
}

}  // namespace limitgauge::verifier
