#include "model/part/kinematics.h"

#include <algorithm>
#include <cmath>

#include "model/base/angle.h"

namespace limitgauge::model {
namespace {

constexpr Vec3 kUp{0, 0, 1};

Pose shift(const Vec3& by_mm) {
  Pose pose;
  pose.shift_mm = by_mm;
  return pose;
}

Pose turn_about_axis(const RotaryAxis& axis, double angle_deg) {
  Pose pose = turn_about(axis.direction, angle_deg);
  pose.shift_mm = axis.point_mm - pose.direction(axis.point_mm);
  return pose;
}

Pose rotation(const Pose& pose) {
  Pose turn = pose;
  turn.shift_mm = {};
  return turn;
}

/// The point of an axis that is nearest to `point`.
Vec3 foot_on(const RotaryAxis& axis, const Vec3& point) {
  return axis.point_mm + axis.direction * dot(axis.direction, point - axis.point_mm);
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

bool Kinematics::is_head(std::size_t i) const {
  return kind == MachineKind::head_head || (kind == MachineKind::head_table && i == 0);
}

Pose Kinematics::table(const RotaryAngles& angles_deg) const {
  Pose pose;
  for (std::size_t i = 0; i < axes.size(); ++i)
    if (!is_head(i)) pose = pose * turn_about_axis(axes[i], angles_deg[axes[i].index()]);
  return pose;
}

Pose Kinematics::head(const RotaryAngles& angles_deg) const {
  Pose pose;
  for (std::size_t i = 0; i < axes.size(); ++i)
    if (is_head(i)) pose = pose * turn_about_axis(axes[i], angles_deg[axes[i].index()]);
  return pose;
}

Pose Kinematics::carried_by(std::optional<char> word, const RotaryAngles& angles_deg) const {
  Pose pose;
  if (!word) return pose;
  for (std::size_t i = 0; i < axes.size(); ++i) {
    if (!is_head(i)) pose = pose * turn_about_axis(axes[i], angles_deg[axes[i].index()]);
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

Pose MotionFrame::in_workpiece(const Kinematics& machine, const RotaryAngles& angles_deg) const {
  if (control == TipControl::tool_centre) return plane;
  const Pose from_machine = machine.table(angles_deg).inverse();
  if (control == TipControl::joints) {
    const Vec3 tool{0, 0, -tool_length_mm};
    return from_machine * shift(machine.head(angles_deg).point(tool) - tool);
  }
  return shift(work_zero_mm) * rotation(from_machine) * shift(Vec3{} - work_zero_mm);
}

RotaryAngles TurningMotion::angles_at(double t) const {
  RotaryAngles angles{};
  for (std::size_t i = 0; i < angles.size(); ++i)
    angles[i] = from_deg[i] + t * (to_deg[i] - from_deg[i]);
  return angles;
}

Pose TurningMotion::tool_at(const Kinematics& machine, double t) const {
  const RotaryAngles angles = angles_at(t);
  Pose tool = rotation(machine.upright(angles)).inverse();
  tool.shift_mm = frame.in_workpiece(machine, angles).point(from_mm + (to_mm - from_mm) * t);
  return tool;
}

double TurningMotion::turn_rad() const {
  double sum = 0;
  for (std::size_t i = 0; i < from_deg.size(); ++i)
    sum += radians(std::abs(to_deg[i] - from_deg[i]));
  return sum;
}

namespace {

/// A bound on something, and on how fast it goes by t.
struct Swing {
  double far_mm = 0, speed_mm = 0;
};

double turn_of_axis_rad(const TurningMotion& motion, const RotaryAxis& axis) {
  return radians(std::abs(motion.to_deg[axis.index()] - motion.from_deg[axis.index()]));
}

/// The tip that heads swing from where it is at zero. What the head in front of another turns lies
/// no farther from the front one than from the point that the other turns about, and that point.
Swing head_swing(const Kinematics& machine, const TurningMotion& motion) {
  Swing swing;
  double arm_mm = 0;
  Vec3 about{0, 0, -motion.frame.tool_length_mm};
  for (std::size_t i = machine.axes.size(); i-- > 0;) {
    if (!machine.is_head(i)) continue;
    const RotaryAxis& axis = machine.axes[i];
    const Vec3 foot = foot_on(axis, about);
    arm_mm += distance(about, foot), about = foot;
    const double from_zero_deg =
        std::max(std::abs(motion.from_deg[axis.index()]), std::abs(motion.to_deg[axis.index()]));
    swing.far_mm += arm_mm * std::min(2.0, radians(from_zero_deg));
    swing.speed_mm += arm_mm * turn_of_axis_rad(motion, axis);
  }
  return swing;
}

/// How fast tables carry a tip that goes with `swing` about the way from `from_mm` to `to_mm`. It
/// is as far from a point of the first axis as in the machine, and from one of the second no
/// farther than from there and they from each other.
double table_speed_mm(const Kinematics& machine, const TurningMotion& motion, const Swing& swing) {
  double speed_mm = 0, arm_mm = swing.far_mm;
  std::optional<Vec3> about;
  for (std::size_t i = 0; i < machine.axes.size(); ++i) {
    if (machine.is_head(i)) continue;
    const RotaryAxis& axis = machine.axes[i];
    const Vec3 foot = foot_on(axis, about.value_or(lerp(motion.from_mm, motion.to_mm, 0.5)));
    arm_mm += about ? distance(*about, foot)
                    : std::max(distance(motion.from_mm, foot), distance(motion.to_mm, foot));
    about = foot;
    speed_mm += arm_mm * turn_of_axis_rad(motion, axis);
  }
  return speed_mm;
}

}  // namespace

double TurningMotion::tip_speed_mm(const Kinematics& machine) const {
  const double straight_mm = distance(from_mm, to_mm);
  switch (frame.control) {
    case TipControl::tool_centre:
      return straight_mm;
    case TipControl::dynamic_offset: {
      double turn = 0;
      for (std::size_t i = 0; i < machine.axes.size(); ++i)
        if (!machine.is_head(i)) turn += turn_of_axis_rad(*this, machine.axes[i]);
      const Vec3& zero = frame.work_zero_mm;
      return straight_mm + turn * std::max(distance(from_mm, zero), distance(to_mm, zero));
    }
    case TipControl::joints:
      break;
  }
  const Swing swing = head_swing(machine, *this);
  return straight_mm + swing.speed_mm + table_speed_mm(machine, *this, swing);
}

}  // namespace limitgauge::model
