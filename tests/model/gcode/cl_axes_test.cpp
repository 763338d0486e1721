#include <cmath>
#include <sstream>

#include "model/gcode/cl_data.h"
#include "model/gcode/turning/turning_path.h"
#include "tests/model/gcode/read_text.h"
#include "tests/support/catch.h"
#include "tests/support/messages.h"

namespace limitgauge::model {
namespace {

using test::assumes;

Program cl_program(const std::string& text, const MachineSetup& machine = {}) {
  std::istringstream in(text);
  return read_program(in, "cl.apt", machine);
}

std::string cl_refusal(const std::string& text) {
  return tests::message_of<InputError>([&] { cl_program("FEDRAT/100\n" + text + "FINI\n"); });
}

TurningPath path_of(const Program& program, const RigidPlacement& in_part = {}) {
  PathOptions options;
  options.start_mm = Vec3{};
  options.machine_in_part = in_part;
  return to_turning_path(program, options);
}

const std::string kTurning =
    "UNITS/MM\nMULTAX/ON\nFROM/0,0,50,0,0,1\nRAPID\nGOTO/1,2,20,0.6,0,0.8\nFEDRAT/300,MMPM\n"
    "GOTO/1,2,3\nGOTO/4,2,3,0,0.6001,0.8\nMULTAX/OFF\nGOTO/4,2,9,0,0.6001,0.8\nFINI\n";

}  // namespace

TEST_CASE("CL data with tool axes are a path that turns its tool", "[unit][cl]") {
  const Program program = cl_program(kTurning);
  CHECK(program.motions.size() == 4);
  REQUIRE(program.axes.has_value());
  const TurningPath made = path_of(program);
  CHECK(made.path.start == Vec3{0, 0, 0});
  CHECK(made.axes.start == Vec3{0, 0, 1});
  REQUIRE(made.path.moves.size() == 4);
  CHECK(made.path.moves[2].to == Vec3{4, 2, 3});
  CHECK(made.path.chord_error_mm == 0);
  CHECK(distance(made.axes.to[0], {0.6, 0, 0.8}) < 1e-15);
  CHECK(made.axes.to[1] == made.axes.to[0]);
  CHECK(std::abs(length(made.axes.to[2]) - 1) < 1e-15);
  CHECK(distance(made.axes.to[2], {0, 0.6, 0.8}) < 1e-4);
  CHECK(made.axes.to[3] == made.axes.to[2]);
  CHECK(assumes(program, "line 5: while the tip goes straight"));
  CHECK(assumes(program, "line 7: three figures are taken to leave"));
  CHECK_FALSE(assumes(program, "before the first GOTO"));
  CHECK_THROWS_AS(to_toolpath(program, 0.01), std::invalid_argument);
}

TEST_CASE("a part of CL data begins with the axis that the one before left", "[unit][cl]") {
  PathOptions options;
  options.first = 2;
  const TurningPath made = to_turning_path(cl_program(kTurning), options);
  CHECK(distance(made.axes.start, {0.6, 0, 0.8}) < 1e-15);
  CHECK(made.path.start == Vec3{1, 2, 3});
  CHECK(made.axes.to.size() == 2);
}

TEST_CASE("tool axes go with the frame of G54 and with the part's", "[unit][cl]") {
  MachineSetup machine;
  machine.work_offsets.front() = WorkOffset{{10, 20, 30}, 90};
  const Program program = cl_program(kTurning, machine);
  CHECK(distance(program.axes->to[0], {0, 0.6, 0.8}) < 1e-15);
  const RigidPlacement frame{180, {1, 0, 0}};
  const TurningPath made = path_of(program, machine_in_part(frame, *machine.work_offsets.front()));
  CHECK(distance(made.axes.to[0], {-0.6, 0, 0.8}) < 1e-15);
  CHECK(distance(made.path.moves[0].to, {0, -2, 20}) < 1e-13);
}

TEST_CASE("CL data whose tool stands upright throughout have no axes", "[unit][cl]") {
  const std::string upright =
      "UNITS/MM\nMULTAX/ON\nFROM/0,0,9,0,0,1\nFEDRAT/10\nGOTO/1,2,3,0,0,0.9995\n"
      "MULTAX/OFF\nGOTO/1,2,4\nFINI\n";
  const Program program = cl_program(upright);
  CHECK_FALSE(program.axes.has_value());
  CHECK(program.assumed.empty());
  CHECK(to_toolpath(program, 0.01).moves.size() == 2);
}

TEST_CASE("without FROM the tool stands at the start as at the first GOTO", "[unit][cl]") {
  const Program program = cl_program("FEDRAT/10\nGOTO/1,2,3,0,1,0\nGOTO/1,2,4,0,1,0\nFINI\n");
  CHECK(program.axes->start == Vec3{0, 1, 0});
  CHECK(assumes(program, "line 2: the tool is taken to stand before the first GOTO as it does"));
  CHECK_FALSE(assumes(program, "while the tip goes straight"));
  // FROM with three figures: upright.
  const Program from = cl_program("FROM/0,0,9\nFEDRAT/10\nGOTO/1,2,3,0,1,0\nFINI\n");
  CHECK(from.axes->start == Vec3{0, 0, 1});
}

TEST_CASE("a tilted FROM is the start of a path that turns upright", "[unit][cl]") {
  const Program program = cl_program("FROM/0,0,9,0.6,0,0.8\nRAPID\nGOTO/1,2,3,0,0,1\nFINI\n");
  REQUIRE(program.axes.has_value());
  CHECK(distance(program.axes->start, {0.6, 0, 0.8}) < 1e-15);
  CHECK(program.axes->to[0] == Vec3{0, 0, 1});
}

TEST_CASE("axes of CL data that cannot be used are refused with their place", "[unit][cl]") {
  CHECK(cl_refusal("GOTO/1,2,3,0,0,0\n") ==
        "cl.apt:2:12: error: a tool axis of length 0; expected a unit vector, within 0.001");
  CHECK(cl_refusal("GOTO/1,2,3,0,0.6,0.81\n") ==
        "cl.apt:2:12: error: a tool axis of length 1.00802; expected a unit vector, within 0.001");
  CHECK_THAT(cl_refusal("GOTO/1,2,3,0,0,x\n"), ContainsSubstring("2:16: error: 'X' is not"));
  CHECK_THAT(cl_refusal("GOTO/1,2,3,0,1e300,1e300\n"), ContainsSubstring("2:12: error: a tool"));
  CHECK_THAT(cl_refusal("GOTO/1,2,3,0,0.6\n"), ContainsSubstring("GOTO with 5 figures"));
  CHECK_THAT(cl_refusal("GOTO/1,2,3,0.6,0,0.8\nGOTO/1,2,3,-0.8,0,-0.6\n"),
             ContainsSubstring("3:12: error: a motion that turns the tool by more than 90"));
  CHECK_THAT(cl_refusal("MULTAX/OFF\nGOTO/1,2,3,0.6,0,0.8\nGOTO/1,2,3,0,0,1\n"),
             ContainsSubstring("4:12: error: a turn of the tool behind MULTAX/OFF"));
  CHECK_THAT(cl_refusal("MULTAX/5\n"), ContainsSubstring("2:8: error: MULTAX with '5'"));
  CHECK_THAT(cl_refusal("MULTAX/ON,ON\n"), ContainsSubstring("several words"));
  CHECK(cl_refusal("MULTAX\nGOTO/1,2,3,0,1,0\nGOTO/1,2,3,1,0,0\n") == "no error");
}

}  // namespace limitgauge::model
