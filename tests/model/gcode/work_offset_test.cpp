#include "tests/model/gcode/read_text.h"
#include "tests/support/catch.h"

using namespace limitgauge::model;
using namespace limitgauge::model::test;

namespace {

MachineSetup two_systems() {
  MachineSetup machine;
  machine.work_offsets[0] = WorkOffset{{100, 200, 300}, 0};
  machine.work_offsets[6] = WorkOffset{{1, 2, 3}, 90};
  return machine;
}

bool near(const Vec3& a, const Vec3& b) {
  // Sums and turns of numbers below 1000.
  return distance(a, b) < 1e-11;
}

}  // namespace

TEST_CASE("motions lie in the machine's frame", "[unit][gcode]") {
  CHECK(end_of_text("G0 X1 Y2 Z3\n", two_systems()) == Vec3{101, 202, 303});
  CHECK(end_of_text("G59.1 G0 X1 Y2 Z3\n", two_systems()) == Vec3{-1, 3, 6});
}

TEST_CASE("the tool stays where it is when the coordinate system changes", "[unit][gcode]") {
  // At (101, 202, 303), which is (200, -100, 300) in G59.1; X is programmed there.
  const Vec3 at = end_of_text("G0 X1 Y2 Z3\nG59.1\nX0\n", two_systems());
  CHECK(near(at, {101, 2, 303}));
}

TEST_CASE("a system that nothing states is an error where it moves the tool", "[unit][gcode]") {
  CHECK(error_of("G55\nG0 X1\n")
            .find("2:1: error: a motion under G55, which nothing states; "
                  "expected the machine's work offset") == 0);
  CHECK(error_of("G0 X1\n",
                 [] {
                   MachineSetup machine;
                   machine.work_offsets[1] = WorkOffset{};
                   return machine;
                 }())
            .find("1:1: error: a motion under G54") == 0);
  CHECK(error_of("G55\nG54\nG0 X1\n") == "no error");
  CHECK(error_of("G0 X5 Y6 Z7\nG55 G10 L20 P0 X0 Y0 Z0\nX1\n") == "no error");
  CHECK(error_of("G10 L2 P2 X1\n").find("1:1: error: G10 sets a part of G55") == 0);
}

TEST_CASE("G10 L2 states an origin and a rotation", "[unit][gcode]") {
  CHECK(end_of_text("G10 L2 P2 X10 Y20 Z30 R90\nG55 G0 X1 Y2 Z3\n") == Vec3{8, 21, 33});
  // The active one: the tool stays, and goes on in the new frame.
  CHECK(end_of_text("G0 X1 Y2 Z3\nG10 L2 P1 X10\nY5\n") == Vec3{1, 5, 3});
  CHECK(end_of_text("G0 X1 Y2 Z3\nG10 L2 P0 X10\nX5\n") == Vec3{15, 2, 3});
  CHECK(end_of_text("G20 G10 L2 P1 X1\nG0 X0 Y0 Z0\n") == Vec3{25.4, 0, 0});
  CHECK(assumes(read_text("G10 L2 P1 X10\n"), "line 1: G10 L2 moves G54 from the machine's zero"));
  CHECK(read_text("G10 L2 P1 X10\n", two_systems()).assumed.empty());
}

TEST_CASE("G10 L20 gives the tool's place new coordinates", "[unit][gcode]") {
  CHECK(end_of_text("G0 X1 Y2 Z3\nG10 L20 P1 X10\nX11\n") == Vec3{2, 2, 3});
  // The other system turned by 90 degrees: its X runs along the machine's Y.
  const Vec3 at = end_of_text("G0 X1 Y2 Z3\nG10 L20 P7 X0 Y0 Z0\nG59.1 G0 X5\n", two_systems());
  CHECK(near(at, {101, 207, 303}));
  CHECK(error_of("G0 X0\nG10 L20 P2 X0 Y0 Z0\n") ==
        "2:15: error: G10 L20 from a place that the program has not stated; expected a motion of "
        "that axis to a coordinate first");
}

TEST_CASE("G92 and G52 shift every system until they are cancelled", "[unit][gcode]") {
  CHECK(end_of_text("G0 X1 Y2 Z3\nG92 X11\nX12\n") == Vec3{2, 2, 3});
  CHECK(end_of_text("G0 X1 Y2 Z3\nG92 X11\nG92.1\nX12\n") == Vec3{12, 2, 3});
  CHECK(end_of_text("G0 X1 Y2 Z3\nG92 X11\nG92.2\nX12\nG92.3\nX13\n") == Vec3{3, 2, 3});
  CHECK(end_of_text("G0 X1 Y2 Z3\nG52 X10 Z-1\nX2 Z0\n") == Vec3{12, 2, -1});
  CHECK(end_of_text("G0 X1 Y2 Z3\nG52 X10\nG52 X0\nX2\n") == Vec3{2, 2, 3});
  CHECK(error_of("G92.3\n").find("1:1: error: G92.3 restores offsets") == 0);
  CHECK(error_of("G92\n").find("1:1: error: 'G92' without an axis word") == 0);
}

TEST_CASE("G92 at the start says where the tool stands", "[unit][gcode]") {
  const Program program = read_text("G92 X10 Y0 Z5\nG0 X11\n");
  CHECK(program.motions[0].to == Vec3{11, 0, 5});
  CHECK(program.motions[0].position_known);
  CHECK(assumes(program, "the tool stands where G92 says, X10 mm of G54"));
  // A fresh machine stands at its zero, as LinuxCNC has it.
  CHECK(end_of_text("G92 X10 Y0 Z5\nG0 X11\n", fresh_machine()) == Vec3{1, 0, 0});
}

TEST_CASE("arcs turn with their coordinate system", "[unit][gcode]") {
  const std::string start = "G10 L2 P1 X5 R90\nG0 X0 Y0 Z0 F10\n";
  const Motion arc = read_text(start + "G2 X10 I5\n").motions.back();
  CHECK(arc.to == Vec3{5, 10, 0});
  CHECK(arc.centre1 == 5);
  CHECK(arc.centre2 == 5);
  CHECK(error_of(start + "G18 G2 X10 I5\n").find("3:5: error: an arc in G18 or G19 under") == 0);
}

TEST_CASE("Haas's G110 to G129 are the frames of G154 P1 to P20", "[unit][gcode]") {
  MachineSetup machine;
  machine.control = Control::haas;
  machine.work_offsets[0] = WorkOffset{{0, 0, 0}, 0};
  machine.extended_offsets[1] = WorkOffset{{1, 2, 3}, 0};
  machine.extended_offsets[4] = WorkOffset{{10, 20, 30}, 0};
  machine.extended_offsets[20] = WorkOffset{{100, 200, 300}, 0};
  const std::string start = "G90 G21 G54\nG0 X0 Y0 Z0\n";
  CHECK(end_of_text(start + "G110 X1. Y1. Z1.\n", machine) == Vec3{2, 3, 4});
  CHECK(end_of_text(start + "G113 X1. Y1. Z1.\n", machine) == Vec3{11, 21, 31});
  CHECK(end_of_text(start + "G129 X1. Y1. Z1.\n", machine) == Vec3{101, 201, 301});
  CHECK(end_of_text(start + "G154 P4 X1. Y1. Z1.\n", machine) == Vec3{11, 21, 31});
  CHECK(error_of(start + "G111 X1.\n", machine).find("3:6: error: a motion under") == 0);
  CHECK(error_of(start + "G113.5 X1.\n", machine).find("3:1: error: unknown code") == 0);
  // Fanuc's G113 ends polar interpolation.
  machine.control = Control::fanuc;
  CHECK(end_of_text(start + "G113\nX1. Y1. Z1.\n", machine) == Vec3{1, 1, 1});
}

TEST_CASE("what a program leaves of offsets is told by the line that set it", "[unit][gcode]") {
  const auto left = [](const std::string& text) {
    return read_text("G90 G21\nG0 X0 Y0 Z5\n" + text + "M2\n", fresh_machine()).offsets_left;
  };
  CHECK(left("") == 0);
  CHECK(left("G92 Z1\nX1\n") == 3);
  CHECK(left("G92 Z1\nX1\nG92.1\n") == 0);
  CHECK(left("G52 X1\nG52 X0\n") == 0);
  CHECK(left("G10 L2 P1 X0 Y0 Z0\n") == 0);
  CHECK(left("X1\nG10 L2 P1 Z1\n") == 4);
  CHECK(left("G10 L2 P1 Z1\nG10 L2 P1 Z0\n") == 0);
  CHECK(left("G10 L1 P3 Z20\n") == 3);
  CHECK(left("G55 X1\n") == 0);
}
