
#include <cmath>
#include <cstring>
#include <limits>
#include <random>

#include "model/text/number_text.h"
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
