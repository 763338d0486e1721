#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "model/gcode/text/operators.h"

namespace limitgauge::model::gcode {

/// LinuxCNC's functions (its documentation, "Functions"); angles in degrees.
enum class Function : std::uint8_t {
  abs,
  acos,
  asin,
  atan,  ///< of two values: arc_tangent
  cos,
  exists,  ///< of a parameter
  exp,
  fix,  ///< down to a whole number
  fup,  ///< up to a whole number
  ln,
  round,  ///< halves away from zero
  sin,
  sqrt,
  tan
};

/// `name` in lower case.
std::optional<Function> function_named(std::string_view name);

/// Of all functions but atan and exists.
Computed apply(Function function, double argument);

/// The same under macro B (Fanuc B-63684EN, 16.3): FIX and FUP go towards and away from zero, ROUND
/// to one of `steps` in a unit (0: to whole numbers), and ASIN of what is negative is refused.
Computed apply_macro(Function function, double argument, double steps);

/// The angle whose tangent is `y` / `x`, -180 to 180; 0 for two zeros.
double arc_tangent_deg(double y, double x);

}  // namespace limitgauge::model::gcode
