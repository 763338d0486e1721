#include "model/gcode/text/operators.h"

#include <array>
#include <cmath>

#include "model/base/tolerance.h"

namespace limitgauge::model::gcode {
namespace {

/// `**` before `*`, which it begins with.
constexpr std::array kOperators = {OperatorText{"**", Operator::power, 5},
                                   OperatorText{"*", Operator::times, 4},
                                   OperatorText{"/", Operator::divided, 4},
                                   OperatorText{"mod", Operator::modulo, 4},
                                   OperatorText{"+", Operator::plus, 3},
                                   OperatorText{"-", Operator::minus, 3},
                                   OperatorText{"eq", Operator::equal, 2},
                                   OperatorText{"ne", Operator::not_equal, 2},
                                   OperatorText{"gt", Operator::greater, 2},
                                   OperatorText{"ge", Operator::greater_or_equal, 2},
                                   OperatorText{"lt", Operator::less, 2},
                                   OperatorText{"le", Operator::less_or_equal, 2},
                                   OperatorText{"and", Operator::logical_and, 1},
                                   OperatorText{"or", Operator::logical_or, 1},
                                   OperatorText{"xor", Operator::logical_xor, 1}};

bool equal(double left, double right) {
  return std::abs(left - right) < kEqualNumbers;
}

double modulo(double left, double right) {
  const double rest = std::fmod(left, right);
  return rest < 0 ? rest + std::abs(right) : rest;
}

Computed divide(double left, double right) {
  if (right == 0) return {0, "a division by zero", "another divisor"};
  return finite(left / right);
}

Computed raise(double base, double exponent) {
  if (base < 0 && std::floor(exponent) != exponent)
    return {0, "a negative number raised to a power that is not whole", "a whole exponent"};
  if (base == 0 && exponent < 0)
    return {0, "zero raised to a negative power", "an exponent of 0 or more"};
  return finite(std::pow(base, exponent));
}

bool holds(Operator operation, double left, double right) {
  switch (operation) {
    case Operator::equal:
      return equal(left, right);
    case Operator::not_equal:
      return !equal(left, right);
    case Operator::greater:
      return left > right;
    case Operator::greater_or_equal:
      return left >= right || equal(left, right);
    case Operator::less:
      return left < right;
    case Operator::less_or_equal:
      return left <= right || equal(left, right);
    case Operator::logical_and:
      return left != 0 && right != 0;
    case Operator::logical_or:
      return left != 0 || right != 0;
    default:
      return (left != 0) != (right != 0);
  }
}

}  // namespace

Computed finite(double value) {
  if (!std::isfinite(value)) return {0, "a result that is no finite number", "smaller numbers"};
  return {value, {}, {}};
}

const OperatorText* operator_at(std::string_view text) {
  if (text.empty()) return nullptr;
  for (const OperatorText& candidate : kOperators) {
    if (candidate.text.front() == text.front() && text.starts_with(candidate.text))
      return &candidate;
  }
  return nullptr;
}

Computed apply(Operator operation, double left, double right) {
  switch (operation) {
    case Operator::power:
      return raise(left, right);
    case Operator::times:
      return finite(left * right);
    case Operator::divided:
      return divide(left, right);
    case Operator::modulo:
      if (right == 0) return {0, "MOD of zero", "another divisor"};
      return finite(modulo(left, right));
    case Operator::plus:
      return finite(left + right);
    case Operator::minus:
      return finite(left - right);
    default:
      return {holds(operation, left, right) ? 1.0 : 0.0, {}, {}};
  }
}

}  // namespace limitgauge::model::gcode
