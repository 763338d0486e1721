#pragma once

#include <cstdint>
#include <string_view>

namespace limitgauge::model::gcode {

/// What a calculation gives, or why it gives nothing.
struct Computed {
  double value = 0;
  std::string_view wrong;  ///< empty where there is a value
  std::string_view expected;
};

/// `value`, or that it is infinite or not a number.
Computed finite(double value);

enum class Operator : std::uint8_t {
  power,
  times,
  divided,
  modulo,
  plus,
  minus,
  equal,
  not_equal,
  greater,
  greater_or_equal,
  less,
  less_or_equal,
  logical_and,
  logical_or,
  logical_xor
};

/// How an operator is written, in lower case, and how closely it binds: 1 to 5, all of them from
/// left to right (LinuxCNC's documentation, "Binary operators").
struct OperatorText {
  std::string_view text;
  Operator operation;
  int precedence;
};

/// The operator that `text` (lower case, no blanks) begins with; null where there is none.
const OperatorText* operator_at(std::string_view text);

/// Comparisons and logical operators give 1 or 0. Numbers closer than 1e-6 are equal, and then also
/// GE and LE of each other. MOD gives 0 or more.
Computed apply(Operator operation, double left, double right);

}  // namespace limitgauge::model::gcode
