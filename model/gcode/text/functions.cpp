#include "model/gcode/text/functions.h"

#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace limitgauge::model::gcode {
namespace {

constexpr auto kNames = std::to_array<std::pair<std::string_view, Function>>({
    {"abs", Function::abs},
    {"acos", Function::acos},
    {"asin", Function::asin},
    {"atan", Function::atan},
    {"cos", Function::cos},
    {"exists", Function::exists},
    {"exp", Function::exp},
    {"fix", Function::fix},
    {"fup", Function::fup},
    {"ln", Function::ln},
    {"round", Function::round},
    {"sin", Function::sin},
    {"sqrt", Function::sqrt},
    {"tan", Function::tan},
});

/// In long double, as LinuxCNC does, so that SIN[180] is nearer to zero than a double's pi is to
/// pi.
long double radians(double degrees) {
  return degrees * std::numbers::pi_v<long double> / 180;
}
double degrees(double radians) {
  return static_cast<double>(radians * 180 / std::numbers::pi_v<long double>);
}

Computed arc(Function function, double argument) {
  if (argument < -1 || argument > 1)
    return {0,
            function == Function::asin ? "ASIN of a number beyond -1 and 1"
                                       : "ACOS of a number beyond -1 and 1",
            "-1 to 1"};
  return {degrees(function == Function::asin ? std::asin(argument) : std::acos(argument)), {}, {}};
}

Computed logarithm(double argument) {
  if (argument <= 0) return {0, "LN of a number that is not positive", "more than 0"};
  return {std::log(argument), {}, {}};
}

Computed root(double argument) {
  if (argument < 0) return {0, "SQRT of a negative number", "0 or more"};
  return {std::sqrt(argument), {}, {}};
}

double rounded(double argument) {
  return std::trunc(argument + (argument < 0 ? -0.5 : 0.5));
}

}  // namespace

std::optional<Function> function_named(std::string_view name) {
  for (const auto& [known, function] : kNames) {
    if (known == name) return function;
  }
  return std::nullopt;
}

Computed apply(Function function, double argument) {
  switch (function) {
    case Function::abs:
      return {std::abs(argument), {}, {}};
    case Function::acos:
    case Function::asin:
      return arc(function, argument);
    case Function::cos:
      return finite(static_cast<double>(std::cos(radians(argument))));
    case Function::exp:
      return finite(std::exp(argument));
    case Function::fix:
      return {std::floor(argument), {}, {}};
    case Function::fup:
      return {std::ceil(argument), {}, {}};
    case Function::ln:
      return logarithm(argument);
    case Function::round:
      return {rounded(argument), {}, {}};
    case Function::sin:
      return finite(static_cast<double>(std::sin(radians(argument))));
    case Function::sqrt:
      return root(argument);
    case Function::tan:
      return finite(static_cast<double>(std::tan(radians(argument))));
    default:
      return {0, "a function of something else than one value", "another function"};
  }
}

Computed apply_macro(Function function, double argument, double steps) {
  if (function == Function::fix) return {std::trunc(argument), {}, {}};
  if (function == Function::fup)
    return {argument < 0 ? std::floor(argument) : std::ceil(argument), {}, {}};
  if (function == Function::round && steps > 0)
    return {std::round(argument * steps) / steps, {}, {}};
  // Parameter 6004#0 chooses between -90 to 90 degrees and 270 to 90.
  if (function == Function::asin && argument < 0)
    return {0,
            "ASIN of a negative value is an angle of 270 degrees or more or below 0, as the "
            "control is set",
            "ASIN of 0 or more, its sign turned afterwards"};
  return apply(function, argument);
}

double arc_tangent_deg(double y, double x) {
  return degrees(std::atan2(y, x));
}

}  // namespace limitgauge::model::gcode
