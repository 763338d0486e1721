#include "app/cli/nearest_key.h"

#include <array>

#include "tests/support/catch.h"

namespace limitgauge::app {

TEST_CASE("the nearest key has the fewest slips of the keyboard", "[unit][job]") {
  const std::array<std::string_view, 4> keys = {"step", "feed", "tolerance", "allowance"};
  CHECK(nearest_key("stpe", keys) == "step");
  CHECK(nearest_key("steps", keys) == "step");
  CHECK(nearest_key("fed", keys) == "feed");
  CHECK(nearest_key("tollerance", keys) == "tolerance");
  CHECK(nearest_key("alowance", keys) == "allowance");
  CHECK(nearest_key("anything", {}).empty());
}

}  // namespace limitgauge::app
