#pragma once

#include <optional>

#include "model/gcode/text/statement.h"
#include "model/geometry/vec2.h"

namespace limitgauge::model::gcode {

/// X and Y by a distance to the origin of the work frame (@) and an angle about it (^), mm and
/// radians; one that is left out stays. In G91 both are added to those of the place before.
/// LinuxCNC, "Polar Coordinates".
struct PolarPlace {
  std::optional<double> distance_mm, angle_rad;
  bool incremental = false;

  /// Whether the place is the same wherever the tool stands.
  bool is_stated() const { return distance_mm && angle_rad && !incremental; }
};

/// What the block's polar words say.
PolarPlace polar_of(const Statement& statement, double unit_mm, bool incremental);
/// The place, from where the tool stands, mm. Throws InputError at a polar word where that is the
/// origin, about which it has no angle, and one is asked for; and beyond any machine.
Vec2 polar_end(const Statement& statement, const PolarPlace& polar, const Vec2& at_mm);

}  // namespace limitgauge::model::gcode
