#include "verifier/cutter/axis_cone.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "verifier/cutter/tilted_box.h"
#include "verifier/tolerance.h"

namespace limitgauge::verifier {
namespace {

using model::Box3;
using model::Vec3;

/// Half diagonal of a box over which a plane is as good as anything.
constexpr double kSmall_mm = 0.3;

/// How far a place is from a box about zero.
double beside_box_mm(const Vec3& half, const Vec3& p) {
  return length(Vec3{std::max(0.0, std::abs(p.x) - half.x), std::max(0.0, std::abs(p.y) - half.y),
                     std::max(0.0, std::abs(p.z) - half.z)});
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

/// Whether all places so near to `p` are below the cores, as every axis of the cone has it:
/// `height` is the highest of them over a core along the cone's own axis, and an axis that leans
/// from it by an angle has that higher by the angle times the way between them at most. Without
/// roots: the square of a sum is no more than twice that of the squares.
bool AxisCone::is_below(double height, double far_square, double radius_square) const {
  return height < 0 &&
         height * height > 2 * spread_rad_ * spread_rad_ * (far_square + radius_square);
}

/// A lower bound of the distance to a profile that stands along the cone's axis, its core anywhere
/// in a box about the one that `from` leads to the place from: by the plane at its middle, which
/// loses little over a small one, and by how low and far out the place is over all of it.
double AxisCone::standing_bound(const CutterProfile& profile, const Vec3& room, const Vec3& from,
                                double enough_mm) const {
  const double along = dot(from, axis_), height = along + profile.core_mm;
  const Vec3 out = from - axis_ * along;
  const double rho = length(out);
  const ProfileDistance d = closed_distance(profile, rho, height);
  const Vec3 gradient = out * (rho > 0 ? d.by_rho / rho : 0) + axis_ * d.by_height;
  const double by_plane = d.value - reach_of(gradient, room);
  if (by_plane > enough_mm || length_squared(room) < kSmall_mm * kSmall_mm) return by_plane;
  const double up = reach_of(axis_, room), least = rho > 0 ? rho - reach_of(out, room) / rho : 0;
  const double open = open_distance(profile, std::max(0.0, least), height + up).value;
  return std::max({by_plane, open, height - up - profile.top_mm});
}

/// A profile that is turned about its core by an angle moves a place that is r from there by no
/// more than r times the angle.
double AxisCone::bound(const CutterProfile& profile, double size_mm, const Box3& cores,
                       const Vec3& p, const Vec3& half, double enough_mm) const {
  const Vec3 room = cores.size() / 2 + half, from = p - cores.centre();
  const double far_square = length_squared(from), radius_square = length_squared(room);
  if (profile.is_whole_ball() &&
      is_below(dot(from, axis_) + reach_of(axis_, room), far_square, radius_square))
    return beside_box_mm(room, from) - profile.rounding_mm - kDistanceRounding_mm;
  const double away = std::sqrt(far_square), radius = std::sqrt(radius_square);
  const double by_size = away - radius - size_mm - kDistanceRounding_mm;
  if (axis_ == Vec3{} || by_size >= enough_mm) return by_size;
  const double turning = spread_rad_ * (away + radius) + kDistanceRounding_mm;
  return std::max(by_size, standing_bound(profile, room, from, enough_mm + turning) - turning);
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
