#pragma once

#include <algorithm>
#include <cmath>

#include "model/machine/turning_motion.h"
#include "tests/model/machine/kinematics_machines.h"

namespace limitgauge::model::test {

/// Of places within some hundred millimetres, turned back and forth.
inline constexpr double kPoseRounding_mm = 1e-8;

/// The unit vector a share of the way along the great circle from `a` to `b`.
inline Vec3 great_circle(const Vec3& a, const Vec3& b, double share) {
  const Vec3 across = cross(a, b);
  const double angle = std::atan2(length(across), dot(a, b));
  if (angle < 1e-12) return a + (b - a) * share;
  const Vec3 side = normalized(cross(across, a));
  return a * std::cos(angle * share) + side * std::sin(angle * share);
}

inline Vec3 axis_of(const Pose& tool) {
  return tool.direction({0, 0, 1});
}

/// What a part of a turning motion is taken for.
struct StraightMove {
  double from = 0, to = 1;
  Vec3 tip_from, tip_to, axis_from, axis_to;

  StraightMove(const Kinematics& machine, const TurningMotion& motion, double begin, double end)
      : from(begin), to(end) {
    const Pose a = motion.tool_at(machine, begin), b = motion.tool_at(machine, end);
    tip_from = a.shift_mm, tip_to = b.shift_mm;
    axis_from = axis_of(a), axis_to = axis_of(b);
  }
  /// How far, a share of the way, places within `reach_mm` of the tip are from where the machine
  /// has them.
  double off_mm(const Kinematics& machine, const TurningMotion& motion, double share,
                double reach_mm) const {
    const Pose tool = motion.tool_at(machine, from + (to - from) * share);
    return distance(tool.shift_mm, tip_from + (tip_to - tip_from) * share) +
           reach_mm * distance(axis_of(tool), great_circle(axis_from, axis_to, share));
  }
};

}  // namespace limitgauge::model::test
