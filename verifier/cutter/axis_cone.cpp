#include "verifier/cutter/axis_cone.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "verifier/tolerance.h"

namespace limitgauge::verifier {
namespace {

using model::Box3;
using model::Vec3;

/// No less than the longest way across an axis to a corner of a box about zero whose half diagonal
/// is `radius_mm`, `along` being what each edge has along the axis: the corners have at least what
/// the longest one leaves of the others.
double across_mm(double radius_mm, const Vec3& along) {
  const double all = along.x + along.y + along.z;
  const double least = 2 * std::max({along.x, along.y, along.z}) - all;
  return least > 0 ? std::sqrt(std::max(0.0, radius_mm * radius_mm - least * least)) : radius_mm;
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
  const Vec3 edges{std::abs(axis_.x) * room.x, std::abs(axis_.y) * room.y,
                   std::abs(axis_.z) * room.z};
  const double up = edges.x + edges.y + edges.z;
  const double rho = std::max(0.0, length(from - axis_ * along) - across_mm(radius, edges));
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
