#include "model/text/message_text.h"

#include <array>

#include "tests/support/catch.h"

using namespace limitgauge::model;

TEST_CASE("the nearest word has the fewest slips of the keyboard", "[unit][message_text]") {
  const std::array<std::string_view, 4> keys = {"step", "feed", "tolerance", "allowance"};
  CHECK(nearest_word("stpe", keys) == "step");
  CHECK(nearest_word("steps", keys) == "step");
  CHECK(nearest_word("fed", keys) == "feed");
  CHECK(nearest_word("FEED", keys) == "feed");
  CHECK(nearest_word("tollerance", keys) == "tolerance");
  CHECK(nearest_word("alowance", keys) == "allowance");
  CHECK(nearest_word("anything", {}).empty());
}

TEST_CASE("what was meant, or nothing", "[unit][message_text]") {
  constexpr std::array<std::string_view, 4> known = {"tool", "stock", "surface", "D"};
  const auto near = [&](std::string_view word) { return meant_word(word, known); };
  CHECK(near("tol") == "tool");
  CHECK(near("Stok") == "stock");
  CHECK(near("d") == "D");
  CHECK(near("otol") == "tool");
  CHECK(near("x").empty());
  CHECK(near("report").empty());
  CHECK(near("").empty());
  CHECK(near(std::string(1000, 'a')).empty());
}

TEST_CASE("quoted text is short and printable", "[unit][message_text]") {
  CHECK(in_quotes("a\x1B[2J\xFF") == "'a?[2J?'");
  CHECK(in_quotes("abc") == "'abc'");
  CHECK(in_quotes(std::string(41, 'a')) == "'" + std::string(40, 'a') + "...'");
}
