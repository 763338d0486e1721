#include "tests/model/gcode/read_text.h"
#include "tests/support/catch.h"

using namespace limitgauge::model;
using namespace limitgauge::model::test;

TEST_CASE("M72 brings back what M70 saved, but not the motion mode", "[unit][gcode]") {
  const Program program = read_text("G21 G90 F100 G0 X0 Y0 Z0\nM70\nG20 G91\nF5 G1 X1\nM72\nX2\n");
  CHECK(program.motions[1].to.x == 25.4);
  CHECK(program.motions[1].feed_mm_min == 127.0F);
  CHECK(program.motions[2].to.x == 2);
  CHECK(program.motions[2].kind == MotionKind::feed);
  CHECK(program.motions[2].feed_mm_min == 100.0F);
}

TEST_CASE("M73 brings it back behind the subroutine, M70 does not", "[unit][gcode]") {
  const auto program = [](const std::string& code) {
    return "o1 sub\n" + code + "\nG91\nG0 X1\no1 endsub\nG90 G0 X5 Y0 Z0\no1 call\nX1\n";
  };
  CHECK(end_of_text(program("M73")).x == 1);
  CHECK(end_of_text(program("M70")).x == 7);
  CHECK(end_of_text(program("M73\nM71")).x == 7);
  // A second call right behind the first is another one; conditions read what is back.
  CHECK(end_of_text("o1 sub\nM73 G91\nG0 X1\no1 endsub\nG90 G0 X5 Y0 Z0\no1 call\no1 call\n"
                    "o2 if [#<_absolute> EQ 1]\nX9\no2 endif\n")
            .x == 9);
}

TEST_CASE("the coordinate system and G43 come back, other offsets cannot", "[unit][gcode]") {
  MachineSetup machine;
  machine.tools = {{1, 50, 6}};
  machine.work_offsets[0] = WorkOffset{};
  machine.work_offsets[1] = WorkOffset{{100, 0, 0}, 0};
  CHECK(end_of_text("G43 G55 G0 X0 Y0 Z1\nM70\nG49 G54\nM72\nX1 Z1\n", machine) == Vec3{101, 0, 1});
  CHECK(end_of_text("G0 X0 Y0 Z1\nM70\nG43\nM72\nX1 Z1\n", machine) == Vec3{1, 0, -49});
  CHECK(error_of("G43.1 Z5\nM70\nG49\nM72\n", machine)
            .find("4:1: error: the saved modal state cannot be brought back") == 0);
  CHECK(error_of("M72\n").find("1:1: error: M72 where no state is saved") == 0);
}
