#include "model/part/kinematics.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "model/base/angle.h"

namespace limitgauge::model {
namespace {

constexpr Vec3 kUp{0, 0, 1};
/// How far a tool's axis may be from the one that is asked for, and a direction from that of an
/// axis about which turning it does nothing.
constexpr double kSameDirection = 1e-9;

Pose rotation(const Pose& pose) {
  Pose turn = pose;
  turn.shift_mm = {};
  return turn;
}

/// The angle about `axis` that brings the part of `from` across it to that of `to`, in degrees;
/// nothing where either has none.
std::optional<double> angle_between(const Vec3& axis, const Vec3& from, const Vec3& to) {
  const Vec3 a = from - axis * dot(axis, from), b = to - axis * dot(axis, to);
  if (length(a) <= kSameDirection || length(b) <= kSameDirection) return std::nullopt;
  return std::atan2(dot(axis, cross(a, b)), dot(a, b)) * 180 / std::numbers::pi;
}

/// The angles θ at which `turning`, turned by θ about `about`, has `wanted` as its part along
/// `along`: p + q cos(θ - φ) = wanted. One or two, in degrees; nothing where turning it does
/// nothing or does not reach so far.
std::vector<double> angles_with_part(const Vec3& along, double wanted, const Vec3& about,
                                     const Vec3& turning) {
  const Vec3 still = about * dot(about, turning), moving = turning - still;
  const double c = dot(along, moving), s = dot(along, cross(about, moving));
  const double reach = std::hypot(c, s), rest = wanted - dot(along, still);
  if (reach <= kSameDirection || std::abs(rest) > reach + kSameDirection) return {};
  const double middle = std::atan2(s, c), half = std::acos(std::clamp(rest / reach, -1.0, 1.0));
  constexpr double kDegrees = 180 / std::numbers::pi;
  return {(middle + half) * kDegrees, (middle - half) * kDegrees};
}

/// Of the angles that are whole turns apart, the one within the limits that is nearest to `from`.
std::optional<double> nearest_turn(const RotaryAxis& axis, double angle_deg, double from_deg) {
  constexpr double kTurn_deg = 360, kRounding_deg = 1e-9;
  const auto within = [&](double value) {
    return value >= axis.low_deg - kRounding_deg && value <= axis.high_deg + kRounding_deg;
  };
  const double nearest = angle_deg + kTurn_deg * std::round((from_deg - angle_deg) / kTurn_deg);
  if (within(nearest)) return nearest;
  const double limit = nearest < axis.low_deg ? axis.low_deg : axis.high_deg;
  const double turns = (limit - nearest) / kTurn_deg;
  const double moved =
      nearest + kTurn_deg * (nearest < axis.low_deg ? std::ceil(turns) : std::floor(turns));
  return within(moved) ? std::optional(moved) : std::nullopt;
}

double longest_way(const RotaryAngles& a, const RotaryAngles& b) {
  double longest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) longest = std::max(longest, std::abs(a[i] - b[i]));
  return longest;
}

}  // namespace

const char* name(MachineKind kind) {
  switch (kind) {
    case MachineKind::table_table:
      return "table-table";
    case MachineKind::head_table:
      return "head-table";
    case MachineKind::head_head:
      break;
  }
  return "head-head";
}

Pose RotaryAxis::turn(double angle_deg) const {
  Pose pose = turn_about(direction, angle_deg);
  pose.shift_mm = point_mm - pose.direction(point_mm);
  return pose;
}

bool Kinematics::is_head(std::size_t i) const {
  return kind == MachineKind::head_head || (kind == MachineKind::head_table && i == 0);
}

Pose Kinematics::table(const RotaryAngles& angles_deg) const {
  Pose pose;
  for (std::size_t i = 0; i < axes.size(); ++i)
    if (!is_head(i)) pose = pose * axes[i].turn(angles_deg[axes[i].index()]);
  return pose;
}

Pose Kinematics::head(const RotaryAngles& angles_deg) const {
  Pose pose;
  for (std::size_t i = 0; i < axes.size(); ++i)
    if (is_head(i)) pose = pose * axes[i].turn(angles_deg[axes[i].index()]);
  return pose;
}

Pose Kinematics::carried_by(std::optional<char> word, const RotaryAngles& angles_deg) const {
  Pose pose;
  if (!word) return pose;
  for (std::size_t i = 0; i < axes.size(); ++i) {
    if (!is_head(i)) pose = pose * axes[i].turn(angles_deg[axes[i].index()]);
    if (axes[i].word == *word) break;
  }
  return pose;
}

ToolStand Kinematics::stand(const Vec3& gauge_mm, const RotaryAngles& angles_deg,
                            double tool_length_mm) const {
  const Pose part = table(angles_deg), tool = head(angles_deg);
  return {part.point_back(gauge_mm + tool.point({0, 0, -tool_length_mm})),
          part.direction_back(tool.direction(kUp))};
}

Pose Kinematics::upright(const RotaryAngles& angles_deg) const {
  return rotation(head(angles_deg)).inverse() * table(angles_deg);
}

const RotaryAxis* Kinematics::axis(char word) const {
  const auto found = std::find_if(axes.begin(), axes.end(),
                                  [word](const RotaryAxis& axis) { return axis.word == word; });
  return found == axes.end() ? nullptr : &*found;
}

namespace {

/// A machine's two axes as an equation R₁(θ₁) w = R₂(θ₂) v, both about unit vectors.
struct AxisEquation {
  const RotaryAxis *first, *second;
  double sign_of_first;  ///< R₁ turns by this times the axis's angle
  Vec3 w, v;
};

/// R₁R₂ a = ẑ of tables; R₁ẑ = R₂ a of a head and a table; R₁R₂ ẑ = a of heads.
AxisEquation equation_for(const Kinematics& machine, const Vec3& axis) {
  const RotaryAxis &first = machine.axes.front(), &second = machine.axes.back();
  switch (machine.kind) {
    case MachineKind::table_table:
      return {&first, &second, -1, kUp, axis};
    case MachineKind::head_table:
      return {&first, &second, 1, kUp, axis};
    case MachineKind::head_head:
      break;
  }
  return {&first, &second, -1, axis, kUp};
}

bool reaches(const Kinematics& machine, const RotaryAngles& angles_deg, const Vec3& axis) {
  return length(machine.stand({}, angles_deg, 0).axis - axis) <= kSameDirection;
}

/// Angles that may do, one after the other made whole with the first axis's.
std::vector<RotaryAngles> candidates(const Kinematics& machine, const Vec3& axis,
                                     const RotaryAngles& from_deg) {
  const AxisEquation e = equation_for(machine, axis);
  std::vector<double> second =
      angles_with_part(e.first->direction, dot(e.first->direction, e.w), e.second->direction, e.v);
  if (machine.axes.size() < 2 || second.empty()) second = {from_deg[e.second->index()]};
  std::vector<RotaryAngles> all;
  for (const double angle : second) {
    RotaryAngles angles = from_deg;
    if (machine.axes.size() > 1) angles[e.second->index()] = angle;
    const Vec3 turned =
        machine.axes.size() > 1 ? turn_about(e.second->direction, angle).direction(e.v) : e.v;
    if (const auto other = angle_between(e.first->direction, e.w, turned))
      angles[e.first->index()] = e.sign_of_first * *other;
    all.push_back(angles);
  }
  return all;
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

}  // namespace

std::optional<RotaryAngles> Kinematics::angles_for(const Vec3& axis,
                                                   const RotaryAngles& from_deg) const {
  if (reaches(*this, from_deg, axis)) return from_deg;
  std::optional<RotaryAngles> best;
  for (const RotaryAngles& angles : candidates(*this, axis, from_deg)) {
    if (!reaches(*this, angles, axis)) continue;
    const auto inside = within_limits(*this, angles, from_deg);
    if (inside && (!best || longest_way(*inside, from_deg) < longest_way(*best, from_deg)))
      best = inside;
  }
  return best;
}

}  // namespace limitgauge::model
