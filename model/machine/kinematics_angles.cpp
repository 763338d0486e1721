#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "model/machine/kinematics.h"

namespace limitgauge::model {
namespace {

constexpr Vec3 kToolAtZero{0, 0, 1};
/// How far a tool's axis may be from the one that is asked for.
constexpr double kSameDirection = 1e-9;
/// Directions closer than this to an axis do not turn about it: far from what matters, which is
/// kSameDirection, and from the 1e-16 at which their angle would be noise.
constexpr double kNoPartAcross = 1e-12;
/// Ways that differ by less are the same: some tens of times what kSameDirection is in degrees, so
/// that neither it nor rounding moves an axis that may stay.
constexpr double kSameWay_deg = 1e-6;
constexpr double kDegrees = 180 / std::numbers::pi;

/// The angle about `axis` that brings the part of `from` across it to that of `to`, in degrees;
/// nothing where either has none.
std::optional<double> angle_about(const Vec3& axis, const Vec3& from, const Vec3& to) {
  const Vec3 a = cross(axis, from), b = cross(axis, to);
  if (length(a) <= kNoPartAcross || length(b) <= kNoPartAcross) return std::nullopt;
  return std::atan2(dot(axis, cross(a, b)), dot(a, b)) * kDegrees;
}

/// The angles that turn `turning` about `about` to where it is as far from `along` as `wanted` is:
/// of the triangle on the sphere with these three sides, the angle at `about`, to either side of
/// where it is nearest. Half angles keep them right where a cosine is nearly 1. Where it does not
/// come so far they lead as far as it comes. None where turning it does nothing.
std::vector<double> angles_as_far(const Vec3& along, const Vec3& wanted, const Vec3& about,
                                  const Vec3& turning) {
  const auto nearest = angle_about(about, turning, along);
  if (!nearest) return {};
  const double far = angle_between(along, wanted), a = angle_between(along, about),
               b = angle_between(about, turning), half_sum = (far + a + b) / 2;
  const double up = std::sin(half_sum - a) * std::sin(half_sum - b);
  const double down = std::sin(half_sum) * std::sin(half_sum - far);
  const double angle =
      2 * std::atan2(std::sqrt(std::max(up, 0.0)), std::sqrt(std::max(down, 0.0))) * kDegrees;
  return {*nearest + angle, *nearest - angle};
}

/// A machine's two axes as an equation R₁(θ₁) w = R₂(θ₂) v, both about unit vectors.
struct AxisEquation {
  double sign_of_first;  ///< R₁ turns by this times the axis's angle
  Vec3 w, v;
};

/// R₁R₂ a = ẑ of tables; R₁ẑ = R₂ a of a head and a table; R₁R₂ ẑ = a of heads.
AxisEquation equation_for(MachineKind kind, const Vec3& axis) {
  switch (kind) {
    case MachineKind::table_table:
      return {-1, kToolAtZero, axis};
    case MachineKind::head_table:
      return {1, kToolAtZero, axis};
    case MachineKind::head_head:
      break;
  }
  return {-1, axis, kToolAtZero};
}

/// Angles that may do. Those by which an axis stays come first.
std::vector<RotaryAngles> candidates(const Kinematics& machine, const Vec3& axis,
                                     const RotaryAngles& start_deg) {
  const AxisEquation e = equation_for(machine.kind, axis);
  const RotaryAxis &first = machine.axes.front(), &second = machine.axes.back();
  const bool two = machine.axes.size() > 1;
  std::vector<double> seconds{start_deg[second.index()]};
  if (two)
    for (const double angle : angles_as_far(first.direction, e.w, second.direction, e.v))
      seconds.push_back(angle);
  std::vector<RotaryAngles> all;
  for (const double angle : seconds) {
    RotaryAngles angles = start_deg;
    angles[second.index()] = angle;
    all.push_back(angles);
    const Vec3 turned = two ? turn_about(second.direction, angle).direction(e.v) : e.v;
    if (const auto other = angle_about(first.direction, e.w, turned)) {
      angles[first.index()] = e.sign_of_first * *other;
      all.push_back(angles);
    }
  }
  return all;
}

/// Of the angles that are whole turns apart, the one within the limits that is nearest to `from`.
std::optional<double> nearest_turn(const RotaryAxis& axis, double angle_deg, double from_deg) {
  constexpr double kTurn_deg = 360, kRounding_deg = 1e-9;
  const double low = axis.low_deg - kRounding_deg, high = axis.high_deg + kRounding_deg;
  double nearest = angle_deg + kTurn_deg * std::round((from_deg - angle_deg) / kTurn_deg);
  if (nearest < low) nearest += kTurn_deg * std::ceil((low - nearest) / kTurn_deg);
  if (nearest > high) nearest += kTurn_deg * std::floor((high - nearest) / kTurn_deg);
  if (nearest < low) return std::nullopt;
  return std::clamp(nearest, axis.low_deg, axis.high_deg);
}

std::optional<RotaryAngles> within_limits(const Kinematics& machine, RotaryAngles angles_deg,
                                          const RotaryAngles& from_deg) {
  for (const RotaryAxis& axis : machine.axes) {
    const auto angle = nearest_turn(axis, angles_deg[axis.index()], from_deg[axis.index()]);
    if (!angle) return std::nullopt;
    angles_deg[axis.index()] = *angle;
  }
  return angles_deg;
}

double longest_way(const RotaryAngles& a, const RotaryAngles& b) {
  double longest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) longest = std::max(longest, std::abs(a[i] - b[i]));
  return longest;
}

}  // namespace

std::optional<RotaryAngles> Kinematics::angles_for(const Vec3& axis,
                                                   const RotaryAngles& from_deg) const {
  const auto reaches = [&](const RotaryAngles& angles_deg) {
    return distance(stand({}, angles_deg, 0).axis, axis) <= kSameDirection;
  };
  RotaryAngles start = from_deg;
  for (const RotaryAxis& rotary : axes)
    start[rotary.index()] = std::clamp(start[rotary.index()], rotary.low_deg, rotary.high_deg);
  if (reaches(start)) return start;
  std::optional<RotaryAngles> best;
  for (const RotaryAngles& angles : candidates(*this, axis, start)) {
    if (!reaches(angles)) continue;
    const auto inside = within_limits(*this, angles, from_deg);
    if (inside &&
        (!best || longest_way(*inside, from_deg) < longest_way(*best, from_deg) - kSameWay_deg))
      best = inside;
  }
  return best;
}

}  // namespace limitgauge::model
