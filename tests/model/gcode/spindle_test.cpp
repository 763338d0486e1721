#include "tests/model/gcode/read_text.h"
#include "tests/support/catch.h"

using namespace limitgauge::model;
using namespace limitgauge::model::test;

TEST_CASE("the M6 that stopped the spindle is named", "[unit][program]") {
  const std::string start = "G21 G90\nT1 M6\nM3 S900\nG0 X0 Y0 Z0\nG1 X1 F90\n";
  CHECK(assumes(read_text(start + "T2 M6\nG0 X2\nG1 X3\n"),
                "line 8: feeds with the spindle at rest: the M6 of line 6 has stopped it"));
  CHECK(!assumes(read_text(start + "T2 M6\nM3\nG1 X3\n"), "spindle at rest"));
  CHECK(!assumes(read_text(start + "M5\nT2 M6\nG1 X3\n"), "spindle at rest"));
}

TEST_CASE("a stop of the program stops the spindle where the control says so", "[unit][program]") {
  const auto read = [](const std::string& stop, Control control) {
    MachineSetup machine;
    machine.control = control;
    const std::string units = control == Control::siemens ? "G71" : "G21";
    return read_text(
        units + " G90 G94 G17 G40\nM3 S900\nG0 X0. Y0. Z0.\n" + stop + "\nG1 X1. F90\n", machine);
  };
  const auto stands = [&](const std::string& stop, Control control) {
    return read(stop, control).motions.back().spindle_stopped;
  };
  CHECK(stands("M0", Control::haas));
  CHECK(assumes(read("M00", Control::haas),
                "line 5: feeds with the spindle at rest: the M0 of line 4 has stopped it"));
  CHECK(stands("M3 M0", Control::haas));
  CHECK_FALSE(stands("M0\nM3", Control::haas));
  CHECK_FALSE(stands("M5\nM0\nM3", Control::haas));
  CHECK_FALSE(stands("M1", Control::haas));
  CHECK(assumes(read("M1", Control::haas),
                "line 5: the spindle is taken to turn behind the M1 of line 4"));
  for (const Control control : {Control::fanuc, Control::mach3, Control::siemens}) {
    CHECK_FALSE(stands("M0", control));
    CHECK(assumes(read("M0", control), "taken to turn behind the M0 of line 4"));
    CHECK_FALSE(assumes(read("M0\nM3", control), "taken to turn behind"));
  }
  for (const Control control : {Control::linuxcnc, Control::grbl}) {
    CHECK_FALSE(stands("M0", control));
    CHECK_FALSE(assumes(read("M0", control), "taken to turn behind"));
  }
}
