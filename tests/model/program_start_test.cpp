#include "model/base/error.h"
#include "model/gcode/program_path.h"
#include "tests/model/gcode/read_text.h"
#include "tests/support/catch.h"

using namespace limitgauge::model;
using namespace limitgauge::model::test;

namespace {

MachineSetup starting_at(const Vec3& tip_mm, bool assumed = false) {
  MachineSetup machine;
  machine.start_mm = tip_mm;
  machine.start_is_assumed = assumed;
  return machine;
}

Toolpath path_from(const std::string& text, const MachineSetup& machine) {
  PathOptions options;
  options.start_mm = machine.start_mm;
  return to_toolpath(read_text(text, machine), options);
}

}  // namespace

TEST_CASE("motions before every axis is named start where the tip stands", "[unit][program]") {
  const MachineSetup machine = starting_at({1, 2, 30}, true);
  const Program program = read_text("G0 X-5\nG1 Z-3 F100\nX20\nG0 Y7\n", machine);
  REQUIRE(program.motions.size() == 4);
  CHECK(program.motions[2].to == Vec3{20, 2, -3});
  CHECK(!program.motions[2].position_known);
  CHECK(!program.motions[0].height_known);
  CHECK(program.motions[1].height_known);
  CHECK(program.motions[3].position_known);
  const Toolpath path = path_from("G0 X-5\nG1 Z-3 F100\nX20\n", machine);
  CHECK(path.start == Vec3{1, 2, 30});
  REQUIRE(path.moves.size() == 3);
  CHECK(path.moves[1].to == Vec3{-5, 2, -3});
  CHECK(path.moves[2].to == Vec3{20, 2, -3});
  CHECK(path.moves[2].kind == MoveKind::feed);
}

TEST_CASE("a stated start makes every axis known", "[unit][program]") {
  const Program program = read_text("G91\nG1 X5 F100\nZ-2\n", starting_at({1, 2, 30}));
  CHECK(program.motions[0].position_known);
  CHECK(program.motions[1].to == Vec3{6, 2, 28});
  // It lies in the frame of G54, wherever that lies on the machine.
  MachineSetup machine = starting_at({1, 2, 30});
  machine.work_offsets[0] = WorkOffset{{100, 50, 7}, 90};
  CHECK(read_text("G91 G1 X5 F100\n", machine).motions[0].to == Vec3{98, 56, 37});
}

TEST_CASE("without a start no feed motion vanishes", "[unit][program]") {
  const auto path_of = [](const std::string& text) { return to_toolpath(read_text(text), 0.01); };
  const Toolpath path = path_of("G0 X1 Y1\nG1 X2 F10\nG0 Z5\n");
  CHECK(path.start == Vec3{1, 1, 0});
  REQUIRE(path.moves.size() == 2);
  CHECK(path.moves[0].to == Vec3{2, 1, 0});
  CHECK(path_of("G1 X1 Y2 Z3 F10\n").moves.size() == 1);
  CHECK(path_of("G2 X0 Y10 I5 J5 F10\n").moves.size() > 1);
  CHECK(path_of("G0 X1 Y1\n").moves.empty());
}

TEST_CASE("an arc from the start goes about its own centre", "[unit][program]") {
  const Toolpath path = path_from("G17 G3 X-10 I-10 F10\n", starting_at({10, 0, 4}));
  CHECK(path.start == Vec3{10, 0, 4});
  CHECK(path.moves.back().to == Vec3{-10, 0, 4});
  for (const Move& move : path.moves) CHECK(move.to.y > -1e-12);
}

TEST_CASE("a tool that is loaded before the first motion has its tip at the start",
          "[unit][program]") {
  MachineSetup machine = starting_at({0, 0, 40});
  machine.tools = {{1, 50, 6}, {2, 80, 8}};
  const Program program = read_text("T1 M6\nG0 X5\nG43 H1 Z10\nX6\nT2 M6\nX7\n", machine);
  CHECK(program.motions[0].to == Vec3{5, 0, 40});
  CHECK(program.motions[1].to == Vec3{5, 0, 10});
  // A change between motions leaves the spindle where it is: the longer tool ends 30 mm lower.
  CHECK(program.motions[3].to == Vec3{7, 0, -20});
  // While the height is only assumed, the next tool is above everything too.
  machine.start_is_assumed = true;
  CHECK(read_text("T1 M6\nG0 X5\nT2 M6\nX7\n", machine).motions[1].to == Vec3{7, 0, 40});
}

TEST_CASE("G92 says where the program started, moves before it included", "[unit][program]") {
  const std::string text = "G0 Z5\nG91 X3\nG90 G92 X10 Y4\nG1 X12 F50\n";
  const Program first = read_text(text, starting_at({0, 0, 40}, true));
  // 3 mm after the start the tool stands at X10.
  REQUIRE(first.start_said_mm[0]);
  CHECK(*first.start_said_mm[0] == 7);
  CHECK(*first.start_said_mm[1] == 4);
  CHECK(!first.start_said_mm[2]);
  const Program again = read_text(text, starting_at({7, 4, 40}, true));
  CHECK(again.motions[0].to == Vec3{7, 4, 5});
  CHECK(again.motions[1].to == Vec3{10, 4, 5});
  CHECK(again.motions[2].to == Vec3{12, 4, 5});
  // Where the job states the start, G92 gives that place another name.
  const Program stated = read_text("G92 X10\nG1 X12 F50\n", starting_at({1, 2, 3}));
  CHECK(stated.motions[0].to == Vec3{3, 2, 3});
}

TEST_CASE("a reference point that nothing states is above the start", "[unit][program]") {
  PathOptions options;
  options.start_mm = Vec3{1, 2, 30};
  options.park_z_mm = 60;
  const Program program =
      read_text("G28 G91 Z0\nG90 G0 X5 Y5\nG1 Z1 F10\n", starting_at(*options.start_mm, true));
  const Toolpath path = to_toolpath(program, options);
  CHECK(path.start == Vec3{1, 2, 30});
  CHECK(path.moves.back().to == Vec3{5, 5, 1});
  bool crossed_above = false;
  for (const Move& move : path.moves) crossed_above |= move.to == Vec3{5, 5, 60};
  CHECK(crossed_above);
}

TEST_CASE("the highest programmed height is one that was named", "[unit][program]") {
  const MachineSetup machine = starting_at({0, 0, 500}, true);
  CHECK(highest_z_mm(read_text("G0 X1\nZ8\nG1 Z-2 F9\n", machine), {}) == 8);
  CHECK(highest_z_mm(read_text("G91 G0 Z8\n", machine), {}) < -1e300);
}
