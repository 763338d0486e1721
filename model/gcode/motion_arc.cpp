#include "model/gcode/motion_arc.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "model/base/tolerance.h"

namespace limitgauge::model {

Arc arc_of(const Motion& motion, const Vec3& start) {
  const auto [first, second, normal] = axes_of(motion.plane);
  const double x1 = start[first] - motion.centre1, y1 = start[second] - motion.centre2;
  const double x2 = motion.to[first] - motion.centre1, y2 = motion.to[second] - motion.centre2;
  const double direction = motion.turns < 0 ? -1 : 1;
  Arc arc;
  arc.centre[first] = motion.centre1, arc.centre[second] = motion.centre2;
  arc.centre[normal] = start[normal];
  arc.axis1[first] = arc.axis2[second] = 1;
  arc.rise_mm[normal] = motion.to[normal] - start[normal];
  arc.angle = std::atan2(y1, x1);
  double forward = direction * (std::atan2(y2, x2) - arc.angle);
  while (forward < kFullTurn_rad) forward += 2 * std::numbers::pi;
  forward += 2 * std::numbers::pi * (std::max(1.0, std::abs(motion.turns)) - 1);
  arc.swept = direction * forward;
  arc.radius_mm = std::hypot(x1, y1);
  arc.radius_growth_mm = std::hypot(x2, y2) - arc.radius_mm;
  return arc;
}

}  // namespace limitgauge::model
