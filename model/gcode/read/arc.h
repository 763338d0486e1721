#pragma once

#include <string>

#include "model/geometry/vec2.h"

namespace limitgauge::model::gcode {

/// An arc's centre in its plane, in mm, or what is wrong with the words that ask for it.
struct ArcCentre {
  Vec2 centre{};
  std::string wrong, expected;  ///< empty where the centre is good
};

/// Checks a given centre by LinuxCNC's rules: neither radius below 0.00127 mm; the radii at start
/// and end differ by at most 100 `spiral_mm`, and by at most `spiral_mm` unless that is within a
/// thousandth of the greater one.
ArcCentre centre_by_offset(Vec2 start, Vec2 end, Vec2 centre, double spiral_mm);
/// The centre of the arc of `radius_mm` (negative: the one that is longer than a half circle).
ArcCentre centre_by_radius(Vec2 start, Vec2 end, double radius_mm, bool counter_clockwise);

/// LinuxCNC's tolerance for the difference of the two radii of an arc, by length unit.
inline constexpr double kSpiralToleranceMm = 2 * 0.01 * 1.4142135623730951;
inline constexpr double kSpiralToleranceInch = 2 * 0.001 * 1.4142135623730951;

}  // namespace limitgauge::model::gcode
