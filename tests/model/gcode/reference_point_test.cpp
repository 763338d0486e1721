#include "tests/model/gcode/read_text.h"
#include "tests/support/catch.h"

using namespace limitgauge::model;
using namespace limitgauge::model::test;

namespace {

const std::string kStart = "G21 G90 G0 X1 Y2 Z3\n";

/// A letter a motion: `z` parked, `a` astray, `.` neither.
std::string states(const std::string& text, const MachineSetup& machine = {}) {
  std::string letters;
  for (const Motion& motion : read_text(text, machine).motions)
    letters += motion.astray ? 'a' : motion.parked ? 'z' : '.';
  return letters;
}

}  // namespace

TEST_CASE("G28 goes by its point to the stored place", "[unit][gcode]") {
  const Program program = read_text(kStart + "G28.1\nG0 X5 Y6 Z7\nG28 X8 Z9\nG30.1\nX0\nG30\n");
  REQUIRE(program.motions.size() == 7);
  CHECK(program.motions[2].to == Vec3{8, 6, 9});
  CHECK(program.motions[3].to == Vec3{1, 6, 3});
  // The point of G30 without axis words is where the tool is.
  CHECK(program.motions[5].to == Vec3{0, 6, 3});
  CHECK(program.motions[6].to == Vec3{1, 6, 3});
  CHECK(program.assumed.empty());
}

TEST_CASE("stored places are the spindle's: a longer tool ends lower", "[unit][gcode]") {
  MachineSetup machine;
  machine.tools = {{1, 50, 6}, {2, 80, 6}};
  machine.work_offsets[0] = WorkOffset{{0, 0, -100}, 0};
  machine.home_mm = Vec3{10, 20, 0};
  CHECK(end_of_text("T1 M6 G43\nG0 X0 Y0 Z5\nG91 G28 Z0\n", machine) == Vec3{0, 0, -50});
  CHECK(end_of_text("T2 M6 G43\nG0 X0 Y0 Z5\nG28\n", machine) == Vec3{10, 20, -80});
  CHECK(end_of_text("T2 M6 G43\nG0 X0 Y0 Z5\nG0 G53 Z-1\n", machine) == Vec3{0, 0, -81});
}

TEST_CASE("a place that nothing states parks Z, and X and Y above it", "[unit][gcode]") {
  CHECK(states(kStart + "G91 G28 Z0\nG90 X5\nZ4\n") == "..zz.");
  CHECK(states(kStart + "G91 G28 Z0\nG28 X0 Y0\nG90 X5\nY6\nZ4\n") == "..zzaaz.");
  CHECK(states(kStart + "G28\nG0 X5 Y5\nZ1\n") == "..az.");
  CHECK(states(kStart + "G0 G53 Z0\nX5\nZ1\n") == ".zz.");
  // Once more, and by way of where it already is.
  CHECK(states(kStart + "G91 G28 Z0\nG28 Z0\nG90 G53 G0 Z0\n") == "..zzzz");
  const Program program = read_text(kStart + "G91 G28 Z0\nG90 X5\n");
  CHECK(program.motions.back().to == Vec3{5, 2, 3});
  CHECK(assumes(program, "line 2: G28 is taken to lead Z above everything"));
}

TEST_CASE("a stated home is an error while the work offset is not stated", "[unit][gcode]") {
  MachineSetup machine;
  machine.home_mm = Vec3{10, 20, 0};
  const auto error = [&](const std::string& text) { return error_of(kStart + text, machine); };
  CHECK(error("G91 G28 Z0\n").starts_with("2:5: error: G28 leads Z to a reference point that is"));
  CHECK(error("G28 Z30\n").ends_with("in the job, or --work-offset)"));
  CHECK(error("G28 X0\n").starts_with("2:1: error: G28 leads X to a reference point"));
  // Of G30 nothing is stated; and what the program stored is known in its own frame.
  CHECK(states(kStart + "G91 G30 Z0\n", machine) == "..z");
  CHECK(states(kStart + "G28.1\nG91 G28 Z0\n", machine) == "...");
  machine.work_offsets[0] = WorkOffset{{0, 0, -100}, 0};
  CHECK(states(kStart + "G91 G28 Z0\n", machine) == "...");
}

TEST_CASE("what would need an unstated place is an error", "[unit][gcode]") {
  CHECK(
      error_of(kStart + "G28 X0 Y0\n").find("2:1: error: G28 moves X while the height is known") ==
      0);
  CHECK(error_of(kStart + "G91 G28 Z0\nG0 Z-1\n").find("3:4: error: 'Z-1' starts where nothing") ==
        0);
  CHECK(error_of(kStart + "G28\nG0 Z5\n").find("3:4: error: Z comes down while nothing states") ==
        0);
  CHECK(error_of(kStart + "G28\nG0 X1 Y1 Z5\n").find("3:10: error: Z comes down") == 0);
  CHECK(error_of(kStart + "G28 Z5\nG92 Z0\n").find("3:5: error: 'Z0' sets an offset where") == 0);
  CHECK(error_of(kStart + "G28 Z5\nG81 X1 Z-1 R1 F5\n").find("3:1: error: a canned cycle from") ==
        0);
  CHECK(error_of(kStart + "G0 G53 X0\n").find("2:8: error: 'X0' in machine coordinates, while") ==
        0);
  CHECK(error_of(kStart + "G0 G53 Z-5\n").find("2:8: error: 'Z-5' in machine") == 0);
  CHECK(error_of(kStart + "G1 G53 Z0 F5\n").find("2:8: error: 'Z0' in machine") == 0);
}

TEST_CASE("G53 beside what it cannot stand beside", "[unit][gcode]") {
  CHECK(error_of("G53 X0\n").find("1:5: error: an axis word without a motion mode") == 0);
  CHECK(error_of(kStart + "G53\n").find("2:1: error: G53 without a motion") == 0);
  CHECK(error_of(kStart + "G91 G53 G0 X0\n").find("2:5: error: G53 in incremental") == 0);
  CHECK(error_of(kStart + "G53 G2 X5 I1\n").find("2:1: error: G53 beside a motion that is not") ==
        0);
}

TEST_CASE("a fresh machine has everything at its zero, and says so", "[unit][gcode]") {
  const Program program = read_text(kStart + "G28\nG55 G0 X3\nG53 Y4\n", fresh_machine());
  CHECK(program.motions[2].to == Vec3{0, 0, 0});
  CHECK(program.motions[4].to == Vec3{3, 4, 0});
  CHECK(assumes(program, "line 2: the reference point of G28 lies at the machine's zero"));
  CHECK(assumes(program, "line 3: G55 lies at the machine's zero"));
}
