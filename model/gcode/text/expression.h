#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "model/gcode/control/control_rules.h"
#include "model/gcode/text/parameters.h"

namespace limitgauge::model::gcode {

/// A place in one line of text: what is read stands from `at` on.
struct Cursor {
  std::string_view line;  ///< without its line end
  std::size_t at = 0;
};

/// Throws the InputError for what is wrong at byte `at` of the line.
using Fail =
    std::function<void(std::size_t at, const std::string& wrong, const std::string& expected)>;

/// Whether what stands at the cursor is meant as a value: a number, a sign, `#`, `[` or a word of
/// two letters or more. Blanks before it do not count.
bool value_begins(Cursor cursor);

/// Reads one RS274/NGC value at the cursor and moves behind it: a number, `#5`, `##5`, `#<name>`,
/// `#[expression]`, `[expression]` or a function of LinuxCNC's (ABS ACOS ASIN ATAN[..]/[..] COS EXP
/// FIX FUP LN ROUND SIN SQRT TAN EXISTS; angles in degrees), with any `-` or `+` before it. Blanks
/// may stand anywhere; letters may be lower case. Binary operators with LinuxCNC's precedence,
/// those of one precedence from left to right: `**`; `*` `/` MOD; `+` `-`; EQ NE GT GE LT LE; AND
/// OR XOR. A sign belongs to its value: `[-2 ** 2]` is 4. What has no finite value (a division by
/// 0, a root of a negative number, an unset parameter) and more than 100 values within each other
/// go to `fail`, which must throw.
///
/// Under macro B (B-63684EN, 16.1 to 16.3) FIX and FUP go towards and away from zero, MOD keeps the
/// sign of what is divided, AND, OR and XOR work on the bits of whole numbers, and what only
/// brackets make clear is refused. A local variable that nothing has set is vacant: 0 in
/// calculations, equal to nothing but #0 and other vacant ones.
double read_value(Cursor& cursor, const Parameters& parameters, const Fail& fail,
                  const ControlRules& rules = rules_of(Control::linuxcnc));
/// The same; nothing for a vacant variable alone. Of a word whose least increment is one of `steps`
/// in a unit: ROUND rounds to that there (B-63684EN, 16.3; Haas 96-8210, "Notes on Functions").
std::optional<double> read_value_or_vacant(Cursor& cursor, const Parameters& parameters,
                                           const Fail& fail, const ControlRules& rules,
                                           double steps = 0);

/// What stands behind `=`: under macro B a calculation without brackets around it.
std::optional<double> read_setting_value(Cursor& cursor, const Parameters& parameters,
                                         const Fail& fail, const ControlRules& rules);

/// The same, but a whole number, within RS274/NGC's 0.0001.
int read_whole_value(Cursor& cursor, const Parameters& parameters, const Fail& fail,
                     const ControlRules& rules = rules_of(Control::linuxcnc));

/// A parameter's number, or its name in lower case and without blanks.
struct ParameterName {
  int number = 0;  ///< where `name` is empty
  std::string name;
};

/// Reads what follows `#`: a whole value from 1 to Parameters::kLargest, or `<name>`.
ParameterName read_parameter_name(Cursor& cursor, const Parameters& parameters, const Fail& fail,
                                  const ControlRules& rules = rules_of(Control::linuxcnc));

/// Reads `<name>`: lower case and without blanks.
std::string read_name(Cursor& cursor, const Fail& fail);

}  // namespace limitgauge::model::gcode
