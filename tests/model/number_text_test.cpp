
#include <cmath>
#include <cstring>
#include <limits>
#include <random>

#include "model/text/number_text.h"
#include "model/text/rounded.h"
#include "tests/support/catch.h"

using namespace limitgauge::model;

TEST_CASE("what is a number and what is not", "[unit][number_text]") {
  CHECK(parse_number("1.5") == 1.5);
  CHECK(parse_number("+1.5e1") == 15.0);
  CHECK(parse_number("-.5") == -0.5);
  for (const char* text :
       {"", "+", "-", "+-1", "1,5", "1 ", " 1", "nan", "inf", "-inf", "1e999", "0x10", "1.5mm"}) {
    CAPTURE(text);
    CHECK_FALSE(parse_number(text));
  }
}

TEST_CASE("shortest decimals", "[unit][number_text]") {
  CHECK(shortest(0.1) == "0.1");
  CHECK(shortest(-0.0) == "0");
  CHECK(shortest(25.4) == "25.4");
  CHECK(shortest(1e300) == "1e+300");
}

TEST_CASE("six digits for messages", "[unit][number_text]") {
  CHECK(six_digits(1.0 / 3) == "0.333333");
  CHECK(six_digits(25.4) == "25.4");
  CHECK(six_digits(1e9) == "1e+09");
}

TEST_CASE("shortest decimals read back as the same number", "[property][number_text]") {
  std::mt19937_64 random(6);
  for (int round = 0; round < 20000; ++round) {
    const std::uint64_t bits = random();
    double value = 0;
    std::memcpy(&value, &bits, sizeof value);
    if (std::isnormal(value)) CHECK(parse_number(shortest(value)) == value);
  }
}

TEST_CASE("numbers are rounded the way that is asked for", "[unit][text]") {
  CHECK(rounded_text(1.25, 1, Rounding::down) == "1.2");
  CHECK(rounded_text(1.21, 1, Rounding::up) == "1.3");
  CHECK(rounded_text(1.26, 1, Rounding::nearest) == "1.3");
  CHECK(rounded_text(-0.0001, 2, Rounding::nearest) == "0.00");
  // 0.3 is no double: its last bits are no digit.
  CHECK(rounded_text(0.1 + 0.2, 1, Rounding::up) == "0.3");
  CHECK(significant_decimals(0.0123, 3) == 4);
  CHECK(significant_decimals(1234, 3) == 0);
  CHECK(without_trailing_zeros("12.500") == "12.5");
  CHECK(without_trailing_zeros("300") == "300");
  CHECK(without_trailing_zeros("3.00") == "3");
}

TEST_CASE("beside a limit a number is printed on its side of it", "[unit][text]") {
  CHECK(rounded_text(4.9996, 1, Rounding::up, 5) == "4.9996");
  CHECK(rounded_text(5.0004, 1, Rounding::down, 5) == "5.0004");
  CHECK(rounded_text(5.0004, 1, Rounding::up, 5) == "5.1");
  CHECK(rounded_text(5, 1, Rounding::up, 5) == "5.0");
  CHECK(rounded_text(5.25, 1, Rounding::up, 5.25) == "5.25");
  // The digits of a double are the last that can tell; more are not made up.
  CHECK(rounded_text(5.000000000000001, 1, Rounding::down, 5) == "5.000000000000001");
}
