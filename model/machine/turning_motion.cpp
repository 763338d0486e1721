#include "model/machine/turning_motion.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "model/base/angle.h"

namespace limitgauge::model {
namespace {

Pose shift(const Vec3& by_mm) {
  Pose pose;
  pose.shift_mm = by_mm;
  return pose;
}

Pose rotation_alone(const Pose& pose) {
  Pose turn = pose;
  turn.shift_mm = {};
  return turn;
}

}  // namespace

Pose MotionFrame::in_workpiece(const Kinematics& machine, const RotaryAngles& angles_deg) const {
  if (control == TipControl::tool_centre)
    return length_error_mm == 0
               ? plane
               : shift(machine.stand({}, angles_deg, 0).axis * length_error_mm) * plane;
  const Pose from_machine = machine.table(angles_deg).inverse();
  if (control == TipControl::joints)
    return from_machine * shift(machine.tip_aside_mm(angles_deg, tool_length_mm));
  return shift(work_zero_mm) * rotation_alone(from_machine) * shift(Vec3{} - work_zero_mm);
}

/// Where tables alone turn and motions are along the machine's axes, they are so to the last bit.
Pose MotionFrame::upright(const Kinematics& machine, const RotaryAngles& angles_deg) const {
  if (!machine.has_head() && control == TipControl::joints) return {};
  if (!machine.has_head() && control == TipControl::dynamic_offset)
    return shift(machine.table(angles_deg).point(work_zero_mm) - work_zero_mm);
  return machine.upright(angles_deg) * in_workpiece(machine, angles_deg);
}

RotaryAngles TurningMotion::angles_at(double t) const {
  RotaryAngles angles{};
  for (std::size_t i = 0; i < angles.size(); ++i)
    angles[i] = from_deg[i] + t * (to_deg[i] - from_deg[i]);
  return angles;
}

Pose TurningMotion::tool_at(const Kinematics& machine, double t) const {
  const RotaryAngles angles = angles_at(t);
  Pose tool = rotation_alone(machine.upright(angles)).inverse();
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

double from_line(const RotaryAxis& axis, const Vec3& p) {
  return length(cross(axis.direction, p - axis.point_mm));
}

/// How fast a tip goes while joints move it, worked out from the outside in: what an axis carries
/// goes round it as far away as it stands, and standing axes are taken as they stand.
class JointSpeed {
 public:
  JointSpeed(const Kinematics& machine, const TurningMotion& motion)
      : machine_(machine), motion_(motion), tool_{0, 0, -motion.frame.tool_length_mm} {
    for (const RotaryAxis& axis : machine.axes)
      rates_.push_back(
          radians(std::abs(motion.to_deg[axis.index()] - motion.from_deg[axis.index()])));
  }

  double tip_mm() const {
    return length(motion_.to_mm - motion_.from_mm) + heads_mm() + tables_mm();
  }

 private:
  std::size_t heads() const {
    std::size_t count = 0;
    while (count < machine_.axes.size() && machine_.is_head(count)) ++count;
    return count;
  }
  bool heads_stand() const {
    return std::all_of(rates_.begin(), rates_.begin() + static_cast<std::ptrdiff_t>(heads()),
                       [](double rate) { return rate == 0; });
  }
  /// The farthest that the tool's tip gets from the axis of the head that carries the others.
  double outer_arm_mm() const {
    const RotaryAxis& outer = machine_.axes.front();
    if (heads() < 2) return from_line(outer, tool_);
    const RotaryAxis& inner = machine_.axes[1];
    if (rates_[1] == 0)
      return from_line(outer, inner.turn(motion_.from_deg[inner.index()]).point(tool_));
    return from_line(outer, inner.point_mm) + length(tool_ - inner.point_mm);
  }
  double heads_mm() const {
    double speed_mm = heads() > 0 ? rates_[0] * outer_arm_mm() : 0;
    if (heads() > 1) speed_mm += rates_[1] * from_line(machine_.axes[1], tool_);
    return speed_mm;
  }
  /// How far heads that turn take the tip from where it would be without them.
  double aside_mm() const {
    if (heads_stand()) return 0;
    return 2 * outer_arm_mm() + (heads() > 1 ? 2 * from_line(machine_.axes[1], tool_) : 0);
  }
  double tables_mm() const;

  const Kinematics& machine_;
  const TurningMotion& motion_;
  Vec3 tool_;
  std::vector<double> rates_;  ///< of the axes, radians by t
};

double JointSpeed::tables_mm() const {
  const std::size_t first = heads();
  if (first == machine_.axes.size()) return 0;
  Vec3 a = motion_.from_mm, b = motion_.to_mm;
  if (first > 0 && heads_stand()) {
    const Vec3 aside = machine_.tip_aside_mm(motion_.from_deg, motion_.frame.tool_length_mm);
    a += aside, b += aside;
  }
  const RotaryAxis& outer = machine_.axes[first];
  double speed_mm =
      rates_[first] * (std::max(from_line(outer, a), from_line(outer, b)) + aside_mm());
  if (first + 1 == machine_.axes.size()) return speed_mm;
  const RotaryAxis& inner = machine_.axes[first + 1];
  const double rate = rates_[first + 1];
  if (rates_[first] == 0) {
    const Pose back = outer.turn(motion_.from_deg[outer.index()]).inverse();
    return speed_mm +
           rate * std::max(from_line(inner, back.point(a)), from_line(inner, back.point(b)));
  }
  const double far_mm = std::max(length(a - outer.point_mm), length(b - outer.point_mm));
  return speed_mm + rate * (far_mm + from_line(inner, outer.point_mm));
}

/// Directions alone turn: about an axis by what lies across it.
double dynamic_speed_mm(const Kinematics& machine, const TurningMotion& motion) {
  const Vec3 zero = motion.frame.work_zero_mm;
  const Vec3 a = motion.from_mm - zero, b = motion.to_mm - zero;
  double speed_mm = length(motion.to_mm - motion.from_mm);
  const RotaryAxis* const outermost = machine.is_head(0) ? nullptr : &machine.axes.front();
  for (std::size_t i = 0; i < machine.axes.size(); ++i) {
    if (machine.is_head(i)) continue;
    const RotaryAxis& axis = machine.axes[i];
    const double rate =
        radians(std::abs(motion.to_deg[axis.index()] - motion.from_deg[axis.index()]));
    const bool first = &axis == outermost || machine.is_head(i - 1);
    const auto across = [&](const Vec3& v) {
      return first ? length(cross(axis.direction, v)) : length(v);
    };
    speed_mm += rate * std::max(across(a), across(b));
  }
  return speed_mm;
}

}  // namespace

double TurningMotion::tip_speed_mm(const Kinematics& machine) const {
  switch (frame.control) {
    case TipControl::tool_centre:
      return length(to_mm - from_mm) + turn_rad() * std::abs(frame.length_error_mm);
    case TipControl::dynamic_offset:
      return dynamic_speed_mm(machine, *this);
    case TipControl::joints:
      break;
  }
  return JointSpeed(machine, *this).tip_mm();
}

/// From the axes the tip is never farther than they are from where it is half-way, it is from
/// there, and they are from each other.
double TurningMotion::machine_tip_speed_mm(const Kinematics& machine) const {
  constexpr double kHalfWay = 0.5;
  const double speed_mm = tip_speed_mm(machine);
  const Vec3 tip = tool_at(machine, kHalfWay).shift_mm;
  double arm_mm = 0, between_mm = 0;
  for (const RotaryAxis& axis : machine.axes) {
    arm_mm = std::max(arm_mm, distance(tip, axis.point_mm));
    between_mm = std::max(between_mm, distance(axis.point_mm, machine.axes.front().point_mm));
  }
  return speed_mm + turn_rad() * (arm_mm + speed_mm * kHalfWay + between_mm);
}

}  // namespace limitgauge::model
