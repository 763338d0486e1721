#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "engine/model/gcode/parameters.h"

namespace limitgauge::model::gcode {

/// A place in one line of text: what is read stands from `at` on.
struct Cursor {
  std::string_view line;  ///< without its line end
  std::size_t at = 0;
};

/// Throws the InputError for what is wrong at byte `at` of the line.
using Fail =
    std::function<void(std::size_t at, const std::string& wrong, const std::string& expected)>;

/// Reads one RS274/NGC value at the cursor and moves behind it: a number, `#5`, `##5`, `#<name>`,
/// `#[expression]`, `[expression]` or a function of LinuxCNC's (ABS ACOS ASIN ATAN[..]/[..] COS EXP
/// FIX FUP LN ROUND SIN SQRT TAN EXISTS; angles in degrees), with `-` or `+` before it. Blanks may
/// stand anywhere; letters may be lower case. Binary operators with LinuxCNC's precedence: `**`;
/// `*` `/` MOD; `+` `-`; EQ NE GT GE LT LE; AND OR XOR. Comparisons give 1 or 0; EQ and NE by
/// LinuxCNC's tolerance of 1e-9... as its source has it. What has no finite value (a division by 0,
/// a root of a negative number, an unset parameter, more than 100 brackets within each other) goes
/// to `fail`, which does not return.
double read_value(Cursor& cursor, const Parameters& parameters, const Fail& fail);

/// Reads what follows `#` on the left of `=`: the number, or the name in lower case without blanks.
struct ParameterName {
  int number = 0;  ///< where `name` is empty
  std::string name;
};
ParameterName read_parameter_name(Cursor& cursor, const Parameters& parameters, const Fail& fail);

}  // namespace limitgauge::model::gcode
