#include "model/machine/machine_setup.h"

#include "model/base/error.h"
#include "tests/model/fixture_files.h"
#include "tests/support/catch.h"

using namespace limitgauge::model;
using limitgauge::model::test::message_of;

namespace {

std::string table_error(const std::string& text) {
  return message_of<InputError>([&] { parse_tool_table(text, "tool.tbl"); });
}

}  // namespace

TEST_CASE("work offsets are called as the codes that select them", "[unit][gcode]") {
  CHECK(work_offset_name(0) == "G54");
  CHECK(work_offset_name(5) == "G59");
  CHECK(work_offset_name(6) == "G59.1");
  CHECK(work_offset_name(8) == "G59.3");
}

TEST_CASE("a tool table as LinuxCNC writes it", "[unit][gcode]") {
  const std::string text =
      ";a remark\nT1 P1 X0 Z+50.25 D6.000 Q0 ;6 mm end mill\n\n  t12 p3 z-1 \r\nT3 D0.5\n";
  const auto tools = parse_tool_table(text, "tool.tbl");
  REQUIRE(tools.size() == 3);
  CHECK(tools[0].number == 1);
  CHECK(tools[0].length_mm == 50.25);
  CHECK(tools[0].diameter_mm == 6);
  CHECK(tools[1].number == 12);
  CHECK(tools[1].length_mm == -1);
  CHECK_FALSE(tools[1].diameter_mm.has_value());
  CHECK_FALSE(tools[2].length_mm.has_value());
  CHECK(parse_tool_table(text, "tool.tbl", true)[0].diameter_mm == 6 * 25.4);
}

TEST_CASE("what is wrong with a tool table has its place", "[unit][gcode]") {
  CHECK(table_error("T1 Z1\nP2 Z3\n") ==
        "tool.tbl:2:1: error: a line without a tool's number; expected T");
  CHECK(table_error("T1 Z1 Z2\n").find("tool.tbl:1:7: error: Z twice in one line") == 0);
  CHECK(table_error("T1 Zabc\n").find("tool.tbl:1:4: error: the number of Z is missing") == 0);
  CHECK(table_error("T1.5\n").find("tool.tbl:1:1: error: a tool number that is no integer") == 0);
  CHECK(table_error("T1\nT1\n").find("tool.tbl:2:1: error: tool 1 twice") == 0);
  CHECK(table_error("T1 X1\n").find("tool.tbl:1:4: error: a tool offset along X") == 0);
  CHECK(table_error("T1 Z1e9\n").find("tool.tbl:1:4: error: a length beyond any tool") == 0);
  CHECK(table_error("T1 Z10001\n").find("10001 mm; expected at most 10000 mm") !=
        std::string::npos);
  CHECK(table_error("T1 *\n").find("tool.tbl:1:4: error: a tool table's line has a word") == 0);
}
