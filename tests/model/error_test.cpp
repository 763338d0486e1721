#include "model/base/error.h"

#include "tests/support/catch.h"

using namespace limitgauge::model;

TEST_CASE("an input error says where, what and what was expected", "[unit][error]") {
  CHECK(std::string(InputError({"a.obj", 3, 5}, "wrong", "right").what()) ==
        "a.obj:3:5: error: wrong; expected right");
  CHECK(std::string(InputError({"a.obj", 3, 0}, "wrong").what()) == "a.obj:3: error: wrong");
  CHECK(std::string(InputError({"a.obj", 0, 5}, "wrong").what()) == "a.obj: error: wrong");
  CHECK(std::string(InputError({}, "wrong").what()) == "error: wrong");
  CHECK(InputError({"a.obj", 3, 5}, "wrong").place().column == 5);
}

TEST_CASE("errors bring no control characters to a terminal", "[unit][error]") {
  const std::string escape = "a\x1b]0;x\x07\u009b\u202eb\nc";
  const std::string clean = "a\uFFFD]0;x\uFFFD\uFFFD\uFFFDb c";
  CHECK(std::string(InputError({escape, 3, 5}, escape, escape).what()) ==
        clean + ":3:5: error: " + clean + "; expected " + clean);
  // A line feed separates what is said.
  CHECK(std::string(ResourceError("a\x1b[2J\nb").what()) == "a\uFFFD[2J\nb");
}
