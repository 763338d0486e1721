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
