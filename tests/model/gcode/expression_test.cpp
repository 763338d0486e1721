#include "model/gcode/text/expression.h"

#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <random>
#include <stdexcept>

#include "tests/support/catch.h"

using namespace limitgauge::model::gcode;

namespace {

struct Wrong : std::runtime_error {
  Wrong(std::size_t place, const std::string& text) : std::runtime_error(text), at(place) {}
  std::size_t at;
};

void fail(std::size_t at, const std::string& wrong, const std::string&) {
  throw Wrong(at, wrong);
}

Parameters some_parameters() {
  Parameters parameters;
  parameters.set(1, 4);
  parameters.set(2, 1);
  parameters.set(4, 2.5);
  parameters.set("width", 30);
  parameters.set("_deep", -7);
  return parameters;
}

double value_of(const std::string& text) {
  static const Parameters parameters = some_parameters();
  Cursor cursor{text};
  const double value = read_value(cursor, parameters, fail);
  CHECK(cursor.at == text.size());
  return value;
}

/// Where the error is, counted from 0, and what it says.
std::string expression_error_of(const std::string& text) {
  static const Parameters parameters = some_parameters();
  Cursor cursor{text};
  try {
    read_value(cursor, parameters, fail);
  } catch (const Wrong& wrong) {
    return std::to_string(wrong.at) + " " + wrong.what();
  }
  return {};
}

/// A random expression and its value, evaluated while it is written, with brackets only where the
/// documented order of operators needs them.
struct Written {
  std::string text;
  double value = 0;
  /// The same operations in the same order, correctly rounded, give the same bits: such values may
  /// be compared and rounded.
  bool same = true;
  /// How far roundings may have been magnified; the tolerance is 1e-9 of it, where a few dozen
  /// roundings of 1e-16 make 1e-14.
  double scale = 1;
  int precedence = 6;  // of the outermost operator; 6: none
};

class RandomExpression {
 public:
  explicit RandomExpression(unsigned seed) : random_(seed) {}

  Written write(int depth) {
    if (depth == 0 || one_in(6)) return leaf();
    if (one_in(3)) return function(write(depth - 1));
    if (one_in(8)) return negative(write(depth - 1));
    const Written left = write(depth - 1), right = write(depth - 1);
    return left.same && right.same && one_in(2) ? comparison(left, right) : sum(left, right);
  }

  /// In any case, with blanks anywhere.
  std::string disguised(const std::string& text) {
    std::string result;
    for (const char c : text) {
      if (one_in(6)) result += one_in(2) ? ' ' : '\t';
      const bool raised = c >= 'a' && c <= 'z' && one_in(2);
      result += raised ? static_cast<char>(c - 'a' + 'A') : c;
    }
    return result;
  }

 private:
  bool one_in(unsigned n) { return random_() % n == 0; }

  Written leaf() {
    const double value = (static_cast<int>(random_() % 81) - 40) / 4.0;
    std::array<char, 32> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value);
    return {std::string(text.data(), end.ptr), value, true, 10};
  }

  static Written negative(const Written& of) {
    return {"-[" + of.text + "]", -of.value, of.same, of.scale};
  }

  Written function(const Written& of) {
    const std::string inner = "[" + of.text + "]";
    const double v = of.value;
    if (of.same) {
      switch (random_() % 8) {
        case 0:
          return {"abs" + inner, std::fabs(v), true, of.scale};
        case 1:
          return {"fix" + inner, std::floor(v), true, of.scale};
        case 2:
          return {"fup" + inner, std::ceil(v), true, of.scale};
        case 3:
          return {"round" + inner, std::round(v), true, of.scale};
        case 4:
          return {"sqrt[abs" + inner + "]", std::sqrt(std::fabs(v)), true, of.scale};
        default:
          break;
      }
    }
    return transcendental(of, inner);
  }

  Written transcendental(const Written& of, const std::string& inner) {
    const double v = of.value, degree = std::numbers::pi / 180;
    if (of.scale < 1e4 && one_in(2)) {
      if (one_in(2)) return {"sin" + inner, std::sin(v * degree), false, of.scale};
      return {"cos" + inner, std::cos(v * degree), false, of.scale};
    }
    if (one_in(2)) return {"ln[1+abs" + inner + "]", std::log(1 + std::fabs(v)), false, of.scale};
    // At most 20 degrees for each 1 of the argument.
    return {"atan" + inner + "/[3]", std::atan2(v, 3.0) / degree, false, 20 * of.scale};
  }

  Written sum(const Written& left, const Written& right) {
    const double a = left.value, b = right.value, s = left.scale, t = right.scale;
    switch (random_() % 5) {
      case 0:
        return joined(left, "*", right, 4, a * b, s * t);
      case 1:
        return joined(left, "+", right, 3, a + b, s + t);
      case 2:
        return joined(left, "-", right, 3, a - b, s + t);
      case 3: {
        Written squared = joined(left, "**", {"2", 2, true, 2}, 5, a * a, s * s);
        squared.same = false;
        return squared;
      }
      default:
        break;
    }
    if (!right.same || b == 0) return left;
    return joined(left, "/", right, 4, a / b, s / std::min(1.0, std::fabs(b)));
  }

  Written comparison(const Written& left, const Written& right) {
    const double a = left.value, b = right.value;
    const bool equal = std::fabs(a - b) < 1e-6;
    switch (random_() % 9) {
      case 0:
        return joined(left, "lt", right, 2, a < b, 1);
      case 1:
        return joined(left, "gt", right, 2, a > b, 1);
      case 2:
        return joined(left, "le", right, 2, a <= b || equal, 1);
      case 3:
        return joined(left, "ge", right, 2, a >= b || equal, 1);
      case 4:
        return joined(left, "eq", right, 2, equal, 1);
      case 5:
        return joined(left, "ne", right, 2, !equal, 1);
      case 6:
        return joined(left, "and", right, 1, a != 0 && b != 0, 1);
      case 7:
        return joined(left, "or", right, 1, a != 0 || b != 0, 1);
      default:
        return joined(left, "xor", right, 1, (a != 0) != (b != 0), 1);
    }
  }

  /// Operators of one precedence go from left to right: the right side needs brackets sooner.
  static Written joined(const Written& left, const std::string& text, const Written& right,
                        int precedence, double value, double scale) {
    const auto side = [](const Written& of, bool brackets) {
      return brackets ? "[" + of.text + "]" : of.text;
    };
    return {side(left, left.precedence < precedence) + text +
                side(right, right.precedence <= precedence),
            value, left.same && right.same, scale, precedence};
  }

  std::mt19937 random_;
};

}  // namespace

TEST_CASE("numbers may have signs, blanks and no digits on one side", "[unit][program]") {
  CHECK(value_of("5") == 5);
  CHECK(value_of("5.") == 5);
  CHECK(value_of(".5") == 0.5);
  CHECK(value_of("-.5") == -0.5);
  CHECK(value_of("+ 1 2 . 5 0") == 12.5);
  CHECK(value_of("--3") == 3);
  CHECK(value_of("-+-[3]") == 3);
  CHECK(value_of("0.1234567890123456789") == 0.1234567890123456789);
}

TEST_CASE("operators bind as LinuxCNC documents", "[unit][program]") {
  CHECK(value_of("[1 + 2 * 3]") == 7);
  CHECK(value_of("[2 ** 3 ** 2]") == 64);
  CHECK(value_of("[-2 ** 2]") == 4);
  CHECK(value_of("[2 * 3 ** 2]") == 18);
  CHECK(value_of("[8 / 4 / 2]") == 1);
  CHECK(value_of("[10 - 4 - 3]") == 3);
  CHECK(value_of("[1 LT 2 EQ 1]") == 1);
  // AND, OR and XOR are of one precedence.
  CHECK(value_of("[1 OR 0 AND 0]") == 0);
  CHECK(value_of("[3 - 1 + 2 * 2 LT 5 AND 1]") == 0);
}

TEST_CASE("MOD is never negative", "[unit][program]") {
  CHECK(value_of("[5 MOD 3]") == 2);
  CHECK(value_of("[-5 MOD 3]") == 1);
  CHECK(value_of("[5 MOD -3]") == 2);
  CHECK(value_of("[-5 MOD -3]") == 1);
}

TEST_CASE("comparisons take numbers closer than a millionth as equal", "[unit][program]") {
  CHECK(value_of("[1.0000005 EQ 1]") == 1);
  CHECK(value_of("[1.000002 EQ 1]") == 0);
  CHECK(value_of("[1.0000005 NE 1]") == 0);
  CHECK(value_of("[1.000002 NE 1]") == 1);
  CHECK(value_of("[1.0000005 LE 1]") == 1);
  CHECK(value_of("[1.000002 LE 1]") == 0);
  CHECK(value_of("[1 GE 1.0000005]") == 1);
  CHECK(value_of("[1 GE 1.000002]") == 0);
  CHECK(value_of("[1.0000005 GT 1]") == 1);
  CHECK(value_of("[1 LT 1.0000005]") == 1);
}

TEST_CASE("functions count in degrees and round as LinuxCNC does", "[unit][program]") {
  // One rounding of results up to 180.
  const auto near = [](double value) { return Approx(value).margin(1e-13); };
  CHECK(value_of("SIN[30]") == near(0.5));
  CHECK(value_of("COS[60]") == near(0.5));
  CHECK(value_of("TAN[45]") == near(1));
  CHECK(value_of("ASIN[0.5]") == near(30));
  CHECK(value_of("ACOS[0.5]") == near(60));
  CHECK(value_of("ATAN[1]/[-1]") == near(135));
  CHECK(value_of("ATAN[-1]/[-1]") == near(-135));
  CHECK(value_of("ATAN[0]/[0]") == 0);
  CHECK(value_of("EXP[1]") == near(std::numbers::e));
  CHECK(value_of("LN[EXP[2]]") == near(2));
  CHECK(value_of("FIX[-2.5]") == -3);
  CHECK(value_of("FUP[-2.5]") == -2);
  CHECK(value_of("ROUND[2.5]") == 3);
  CHECK(value_of("ROUND[-2.5]") == -3);
  CHECK(value_of("ABS[-2.5]") == 2.5);
  CHECK(value_of("a t a n [ 1 ] / [ 1 ]") == near(45));
}

TEST_CASE("parameters are read by number, name and calculation", "[unit][program]") {
  CHECK(value_of("#1") == 4);
  CHECK(value_of("##1") == 2.5);
  CHECK(value_of("#[#2 + 3]") == 2.5);
  CHECK(value_of("#ROUND[0.9]") == 4);
  CHECK(value_of("# 1") == 4);
  CHECK(value_of("-#1") == -4);
  CHECK(value_of("#<width>") == 30);
  CHECK(value_of("#< W i d TH >") == 30);
  CHECK(value_of("[#<_deep> * 2]") == -14);
  CHECK(value_of("#0.99995") == 4);
  CHECK(value_of("#1.00005") == 4);
}

TEST_CASE("EXISTS asks whether a name was set; every number does", "[unit][program]") {
  CHECK(value_of("EXISTS[#<width>]") == 1);
  CHECK(value_of("EXISTS[#<height>]") == 0);
  CHECK(value_of("EXISTS[#<_deep>]") == 1);
  CHECK(value_of("EXISTS[#77]") == 1);
}

TEST_CASE("what has no value is an error at its place", "[unit][program]") {
  CHECK(expression_error_of("[1 / [2 - 2]]") == "3 a division by zero");
  CHECK(expression_error_of("[1 + 5 MOD 0]") == "7 MOD of zero");
  CHECK(expression_error_of("[[-8] ** 0.5]") ==
        "6 a negative number raised to a power that is not whole");
  CHECK(expression_error_of("[0 ** -1]") == "3 zero raised to a negative power");
  CHECK(expression_error_of("SQRT[-1]") == "0 SQRT of a negative number");
  CHECK(expression_error_of("LN[0]") == "0 LN of a number that is not positive");
  CHECK(expression_error_of("ACOS[1.01]") == "0 ACOS of a number beyond -1 and 1");
  CHECK(expression_error_of("ASIN[-1.01]") == "0 ASIN of a number beyond -1 and 1");
  CHECK(expression_error_of("[1 + EXP[800]]") == "5 a result that is no finite number");
  CHECK(expression_error_of("[EXP[700] * EXP[700]]") == "10 a result that is no finite number");
  CHECK(expression_error_of("[1 + #3]") == "5 parameter #3 was never set");
  CHECK(expression_error_of("#<height>") == "0 parameter '#<height>' was never set");
  CHECK(expression_error_of("#0") == "1 parameter number 0");
  CHECK(expression_error_of("#6000") == "1 parameter number 6000");
  CHECK(expression_error_of("#-1") == "1 parameter number -1");
  CHECK(expression_error_of("#1.5") == "1 1.5 where a whole number is needed");
  CHECK(expression_error_of("#[10 ** 10]") == "1 1e+10 where a whole number is needed");
}

TEST_CASE("what is no expression is an error at its place", "[unit][program]") {
  CHECK(expression_error_of("[1 + [2 * 3]") == "0 '[' is not closed in its line");
  CHECK(expression_error_of("[1 PLUS 2]") == "3 'p' behind a value");
  CHECK(expression_error_of("[1 + * 2]") == "5 '*' where a value is missing");
  CHECK(expression_error_of("[1 +") == "4 the line ends where a value is missing");
  CHECK(expression_error_of("") == "0 the line ends where a value is missing");
  CHECK(expression_error_of("SINH[1]") == "0 'sinh' is no function");
  CHECK(expression_error_of("SIN 1") == "4 a function without its argument");
  CHECK(expression_error_of("ATAN[1]") == "7 ATAN with one argument");
  CHECK(expression_error_of("ATAN[1]/2") == "8 ATAN without its second argument");
  CHECK(expression_error_of("EXISTS[5]") == "7 '5' within a value");
  CHECK(expression_error_of("EXISTS[#1") == "9 the line ends within a value");
  CHECK(expression_error_of("1.2.3") == "0 '1.2.3' is not a number");
  CHECK(expression_error_of("[1 + " + std::string(400, '9') + "]") ==
        "5 '" + std::string(40, '9') + "...' is too large or too small");
  CHECK(expression_error_of("1 . 2 .") == "0 '1.2.' is not a number");
  CHECK(expression_error_of(".") == "0 '.' is not a number");
  CHECK(expression_error_of("#<width") == "1 the name does not end in its line");
  CHECK(expression_error_of("#<>") == "1 a name without a letter");
  CHECK(expression_error_of("#<a(b)>") == "3 '(' within a name");
}

TEST_CASE("values within each other are bounded, however they are nested", "[unit][program]") {
  const std::string open(1000, '['), close(1000, ']');
  CHECK(value_of(open.substr(901) + "1" + close.substr(901)) == 1);
  CHECK(expression_error_of(open + "1" + close) == "100 more than 100 values within each other");
  CHECK(expression_error_of(std::string(1000, '-') + "1") ==
        "100 more than 100 values within each other");
  CHECK(expression_error_of(std::string(1000, '#') + "1") ==
        "100 more than 100 values within each other");
  // Side by side there may be any number.
  std::string sum = "[1";
  for (int i = 0; i < 1000; ++i) sum += "+[1]";
  CHECK(value_of(sum + "]") == 1001);
}

TEST_CASE("a value ends where it cannot go on", "[unit][program]") {
  const std::vector<std::pair<std::string, std::size_t>> ends = {
      {"5 Y3", 1}, {"1 2 Y3", 3}, {"[1] 2", 3}, {"#1 =5", 2}, {"5(five)", 1}, {"SIN[0]X", 6}};
  const Parameters parameters = some_parameters();
  for (const auto& [text, end] : ends) {
    CAPTURE(text);
    Cursor cursor{text};
    read_value(cursor, parameters, fail);
    CHECK(cursor.at == end);
  }
}

TEST_CASE("random expressions have the value that their tree has", "[property][program]") {
  RandomExpression random(11);
  std::size_t operators = 0;
  for (int round = 0; round < 20000; ++round) {
    const Written written = random.write(5);
    const std::string text = random.disguised("[" + written.text + "]");
    CAPTURE(text);
    operators += written.precedence < 6 ? 1 : 0;
    REQUIRE(std::fabs(value_of(text) - written.value) <= 1e-9 * written.scale);
  }
  CHECK(operators > 5000);
}

TEST_CASE("random bytes give a value or an error", "[property][program]") {
  std::mt19937 random(12);
  const std::string alphabet = "[]]#<>+-*/.0123456789 sincoatmdexrqpul=(;";
  const Parameters parameters = some_parameters();
  std::size_t values = 0;
  for (int round = 0; round < 50000; ++round) {
    std::string text;
    for (std::size_t length = random() % 12; length > 0; --length)
      text += alphabet[random() % alphabet.size()];
    Cursor cursor{text};
    try {
      const double value = read_value(cursor, parameters, fail);
      ++values;
      CHECK(std::isfinite(value));
    } catch (const Wrong& wrong) {
      CHECK(wrong.at <= text.size());
    }
    CHECK(cursor.at <= text.size());
  }
  CHECK(values > 1000);
}
