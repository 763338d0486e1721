#include "model/base/words.h"

#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>

#include "tests/support/catch.h"

using namespace limitgauge::model;

TEST_CASE("what is a number and what is not", "[unit][words]") {
  CHECK(parse_number("1.5") == 1.5);
  CHECK(parse_number("+1.5e1") == 15.0);
  CHECK(parse_number("-.5") == -0.5);
  for (const char* text :
       {"", "+", "-", "+-1", "1,5", "1 ", " 1", "nan", "inf", "-inf", "1e999", "0x10", "1.5mm"}) {
    CAPTURE(text);
    CHECK_FALSE(parse_number(text));
  }
}

TEST_CASE("shortest decimals", "[unit][words]") {
  CHECK(shortest(0.1) == "0.1");
  CHECK(shortest(-0.0) == "0");
  CHECK(shortest(25.4) == "25.4");
  CHECK(shortest(1e300) == "1e+300");
}

TEST_CASE("shortest decimals read back as the same number", "[property][words]") {
  std::mt19937_64 random(6);
  for (int round = 0; round < 20000; ++round) {
    const std::uint64_t bits = random();
    double value = 0;
    std::memcpy(&value, &bits, sizeof value);
    if (std::isnormal(value)) CHECK(parse_number(shortest(value)) == value);
  }
}

TEST_CASE("the nearest word is what was meant, or nothing", "[unit][words]") {
  constexpr std::array<std::string_view, 4> known = {"tool", "stock", "surface", "D"};
  const auto near = [&](std::string_view word) {
    return nearest_word(word, known.data(), known.size());
  };
  CHECK(near("tol") == "tool");
  CHECK(near("Stok") == "stock");
  CHECK(near("d") == "D");
  CHECK(near("x").empty());
  CHECK(near("report").empty());
  CHECK(near("").empty());
  CHECK(near(std::string(1000, 'a')).empty());
}

TEST_CASE("quoted text is short and printable", "[unit][words]") {
  CHECK(in_quotes("a\x1B[2J\xFF") == "'a?[2J?'");
  CHECK(in_quotes("abc") == "'abc'");
  CHECK(in_quotes(std::string(41, 'a')) == "'" + std::string(40, 'a') + "...'");
}
