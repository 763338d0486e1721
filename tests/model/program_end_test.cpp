#include "model/gcode/program.h"
#include "tests/model/gcode/read_text.h"
#include "tests/support/catch.h"

using namespace limitgauge::model;
using namespace limitgauge::model::test;

TEST_CASE("a program that nothing ends is told", "[unit][program]") {
  for (const char* text : {"G0 X1\nM30\n", "G0 X1\nM2", "%\nG0 X1\n%\n", "%\nG0 X1\nM30\n"})
    CHECK(read_text(text).has_end);
  const Program lines = read_text("G0 X1\n");
  CHECK(!lines.has_end);
  CHECK(missing_end_words(lines) ==
        "ends without M2, M30 or '%': taken to be whole, it may have been cut off");
  CHECK_THAT(missing_end_words(read_text("G0 X1")), ContainsSubstring("without a line end"));
}
