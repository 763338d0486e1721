// Where the tip stands on the machine and over the part, each position worked out by hand from what
// the codes are documented to do. Simulator and verifier take their paths from the same reader.
#include <cmath>

#include "model/gcode/program_path.h"
#include "tests/model/gcode/read_text.h"
#include "tests/support/catch.h"

using namespace limitgauge::model;
using namespace limitgauge::model::test;

namespace {

/// A few additions of lengths below 1000 mm, and one turn by 30 degrees: an ulp is 1.1e-13.
constexpr double kGroundMarginMm = 1e-12;

struct Case {
  std::string program;
  Vec3 tip_mm;  ///< of the last motion
};

void check(const MachineSetup& machine, const std::vector<Case>& cases) {
  for (const Case& one : cases) {
    CAPTURE(one.program);
    const Vec3 tip_mm = end_of_text(one.program, machine);
    CAPTURE(tip_mm.x, tip_mm.y, tip_mm.z);
    CHECK(distance(tip_mm, one.tip_mm) <= kGroundMarginMm);
  }
}

MachineSetup shop() {
  MachineSetup machine;
  machine.work_offsets[0] = WorkOffset{{100, 50, 7}, 0};
  machine.work_offsets[1] = WorkOffset{{300, -20, 5}, 90};
  machine.work_offsets[6] = WorkOffset{{10, 20, 30}, 30};
  machine.tools = {{1, 50, 6}, {2, 80, 8}};
  machine.loaded_tool = 1;
  return machine;
}

}  // namespace

TEST_CASE("tool lengths by hand", "[unit][gcode]") {
  // Tip = G54 + programmed + offset in use - true length.
  check(shop(), {
                    {"G43 H1\nG0 X1 Y2 Z3\n", {101, 52, 10}},
                    {"G0 X1 Y2 Z3\n", {101, 52, 10 - 50}},
                    {"G43 H2\nG0 X1 Y2 Z3\n", {101, 52, 10 + 80 - 50}},
                    {"T2 M6\nG43 H2\nG0 X1 Y2 Z3\n", {101, 52, 10}},
                    {"T2 M6\nG43 H1\nG0 X1 Y2 Z3\n", {101, 52, 10 + 50 - 80}},
                    {"G43 H1\nG0 X1 Y2 Z3\nG49\nG0 Z3\n", {101, 52, 10 - 50}},
                    {"G43.1 Z52\nG0 X1 Y2 Z3\n", {101, 52, 10 + 52 - 50}},
                    {"G43 H1\nG43.2 H2\nG0 X1 Y2 Z3\n", {101, 52, 10 + 50 + 80 - 50}},
                    // G10 L1 changes the table that H asks, not the tool.
                    {"G10 L1 P1 Z53\nG43 H1\nG0 X1 Y2 Z3\n", {101, 52, 10 + 53 - 50}},
                    {"G20\nG10 L1 P1 Z2\nG21\nG43 H1\nG0 X1 Y2 Z3\n", {101, 52, 10 + 50.8 - 50}},
                    // What changes an offset moves nothing: only the next Z does.
                    {"G43 H1\nG0 X1 Y2 Z3\nG43 H2\nG0 X4\n", {104, 52, 10}},
                });
}

TEST_CASE("lengths from a tool table's text", "[unit][gcode]") {
  MachineSetup machine;
  machine.tools = parse_tool_table("T3 P1 Z61.25 D6\nT4 P2 Z2 D10 ; short\n", "tool.tbl");
  check(machine, {{"T3 M6\nG43 H3\nG0 X0 Y0 Z1\n", {0, 0, 1}},
                  {"T3 M6\nG43 H4\nG0 X0 Y0 Z1\n", {0, 0, 1 + 2 - 61.25}},
                  {"T4 M6\nG0 X0 Y0 Z1\n", {0, 0, -1}}});
  machine.tools = parse_tool_table("T3 Z2\n", "tool.tbl", true);
  check(machine, {{"T3 M6\nG0 X0 Y0 Z60\n", {0, 0, 60 - 50.8}}});
}

TEST_CASE("frames by hand", "[unit][gcode]") {
  const double c = std::sqrt(3.0) / 2, s = 0.5;
  const std::string tip = "G43 H1\n";
  check(shop(), {
                    // A quarter turn: work X runs along the machine's Y, work Y against its X.
                    {tip + "G55\nG0 X1 Y2 Z3\n", {300 - 2, -20 + 1, 8}},
                    {tip + "G59.1\nG0 X10 Y0 Z3\n", {10 + 10 * c, 20 + 10 * s, 33}},
                    {tip + "G59.1\nG0 X0 Y10 Z3\n", {10 - 10 * s, 20 + 10 * c, 33}},
                    {tip + "G0 X1 Y2 Z3\nG92 X0 Y0 Z0\nG0 X5 Y6 Z7\n", {106, 58, 17}},
                    {tip + "G0 X1 Y2 Z3\nG92 X0\nG55\nG0 X5 Y6 Z7\n", {300 - 6, -20 + 6, 12}},
                    {tip + "G0 X1 Y2 Z3\nG92 X0 Y0 Z0\nG92.1\nG0 X5 Y6 Z7\n", {105, 56, 14}},
                    {tip + "G52 X10 Y20 Z1\nG0 X5 Y6 Z7\n", {115, 76, 15}},
                    {tip + "G52 X10 Y20 Z1\nG52 X0 Y0 Z0\nG0 X5 Y6 Z7\n", {105, 56, 14}},
                    // Offsets of G52 and G92 are turned with the frame.
                    {tip + "G52 X10\nG55\nG0 X0 Y0 Z0\n", {300, -20 + 10, 5}},
                    {tip + "G10 L2 P1 X1 Y2 Z3\nG0 X5 Y6 Z7\n", {6, 8, 10}},
                    {tip + "G10 L2 P3 X1 Y2 Z3 R-90\nG56\nG0 X5 Y6 Z7\n", {1 + 6, 2 - 5, 10}},
                    // G10 L20: where the tool stands is X0 Y0 of the active frame.
                    {tip + "G0 X1 Y2 Z3\nG10 L20 P1 X0 Y0\nG0 X5 Y6\n", {106, 58, 10}},
                });
}

TEST_CASE("inches and increments by hand", "[unit][gcode]") {
  check({}, {{"G20\nG0 X1 Y-2 Z0.5\n", {25.4, -50.8, 12.7}},
             {"G0 X1 Y1 Z1\nG91\nG0 X2\nX3 Y-4\nZ0.5\n", {6, -3, 1.5}},
             {"G0 X1 Y1 Z1\nG20 G91\nG0 X1\nG21 G90\nG0 Y2\n", {26.4, 2, 1}}});
}

TEST_CASE("where a program lies over the part", "[unit][program]") {
  // G54 at (100, 50, 7) on the machine, turned by 90 degrees there; its zero over the part at
  // (1, 2, 3), turned by 30 degrees: a work point p lies at (1, 2, 3) + turn30(p), whatever the
  // machine's frame is.
  MachineSetup machine;
  machine.work_offsets[0] = WorkOffset{{100, 50, 7}, 90};
  machine.work_offsets[1] = WorkOffset{{100, 60, 7}, 90};
  PathOptions options;
  options.machine_in_part = machine_in_part({30, {1, 2, 3}}, *machine.work_offsets[0]);
  options.start_mm = Vec3{100, 50, 107};
  const double c = std::sqrt(3.0) / 2, s = 0.5;
  const auto end_of = [&](const std::string& text) {
    return to_toolpath(read_text(text, machine), options).moves.back().to;
  };
  CHECK(distance(end_of("G0 X10 Y0 Z5\n"), {1 + 10 * c, 2 + 10 * s, 8}) < kGroundMarginMm);
  CHECK(distance(end_of("G0 X0 Y10 Z5\n"), {1 - 10 * s, 2 + 10 * c, 8}) < kGroundMarginMm);
  // G55 lies 10 mm along the machine's Y, which is 10 mm along the work frame's X.
  CHECK(distance(end_of("G55\nG0 X0 Y0 Z5\n"), {1 + 10 * c, 2 + 10 * s, 8}) < kGroundMarginMm);
  const Toolpath path = to_toolpath(read_text("G0 X0 Y0 Z5\n", machine), options);
  CHECK(distance(path.start, {1, 2, 103}) < kGroundMarginMm);
}
