#include "app/cli/terminal.h"

#include "tests/support/catch.h"

namespace limitgauge::app {
namespace {

TEST_CASE("colour is for terminals that take it and users who want it", "[unit][terminal]") {
  CHECK(may_colour(true, nullptr, "xterm"));
  CHECK(may_colour(true, "", "xterm"));  // no-color.org: set and not empty
  CHECK_FALSE(may_colour(true, "1", "xterm"));
  CHECK_FALSE(may_colour(true, "0", "xterm"));
  CHECK_FALSE(may_colour(true, nullptr, "dumb"));
  CHECK_FALSE(may_colour(true, nullptr, nullptr));
  CHECK_FALSE(may_colour(false, nullptr, "xterm"));
}

TEST_CASE("a line is drawn again only where that can be done", "[unit][terminal]") {
  CHECK(may_redraw(true, "linux"));
  CHECK_FALSE(may_redraw(true, "dumb"));
  CHECK_FALSE(may_redraw(true, ""));
  CHECK_FALSE(may_redraw(false, "linux"));
}

TEST_CASE("what is no terminal has the width that is usual for it", "[unit][terminal]") {
  CHECK(columns_of(-1, 100) == 100);
}

}  // namespace
}  // namespace limitgauge::app
