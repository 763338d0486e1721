#include "tests/model/gcode/read_text.h"
#include "tests/support/catch.h"

using namespace limitgauge::model;
using namespace limitgauge::model::test;

namespace {

MachineSetup two_tools() {
  MachineSetup machine;
  machine.tools = {{1, 50, 6}, {2, 80, std::nullopt}};
  return machine;
}

double last_z(const std::string& text, const MachineSetup& machine = {}) {
  return end_of_text(text, machine).z;
}

}  // namespace

TEST_CASE("with lengths stated the tip lies where offset less length puts it", "[unit][gcode]") {
  CHECK(last_z("T1 M6\nG43 H1\nG0 Z10\n", two_tools()) == 10);
  CHECK(last_z("T1 M6\nG43\nG0 Z10\n", two_tools()) == 10);
  CHECK(last_z("T1 M6\nG43 H0\nG0 Z10\n", two_tools()) == 10);
  // Another tool's offset, and none at all: 30 mm too high, 50 mm too low.
  CHECK(last_z("T1 M6\nG43 H2\nG0 Z10\n", two_tools()) == 40);
  CHECK(last_z("T1 M6\nG0 Z10\n", two_tools()) == -40);
  CHECK(last_z("T1 M6\nG43 H1\nG0 Z10\nG49\nZ10\n", two_tools()) == -40);
  CHECK(last_z("T1 M6\nG43.1 Z51\nG0 Z10\n", two_tools()) == 11);
  CHECK(last_z("T1 M6\nG43 H1\nG43.2 H2\nG0 Z10\n", two_tools()) == 90);
  CHECK(last_z("T1 M6\nG10 L1 P1 Z50.5\nG43\nG0 Z10\n", two_tools()) == 10.5);
}

TEST_CASE("an offset does not move the tool", "[unit][gcode]") {
  // Programmed 10 without offset is the tip at -40; under G43 it stands at -40 still.
  CHECK(last_z("T1 M6\nG0 X0 Z10\nG43\nX1\n", two_tools()) == -40);
  CHECK(last_z("T1 M6\nG0 X0 Z10\nG43\nG91 Z1\n", two_tools()) == -39);
}

TEST_CASE("a tool change leaves the spindle where it is", "[unit][gcode]") {
  // The second tool is 30 mm longer: its tip comes 30 mm lower.
  CHECK(last_z("T1 M6 G43\nG0 X0 Z10\nT2 M6\nX1\n", two_tools()) == -20);
  CHECK(last_z("T1 M6 G43\nG0 X0 Z10\nT2 M6 G43\nZ10\n", two_tools()) == 10);
  CHECK(last_z("T1 M6 G43\nG0 X0 Z10\nM61 Q2\nX1\n", two_tools()) == -20);
}

TEST_CASE("without lengths the offset of the tool itself is its length", "[unit][gcode]") {
  const Program program = read_text("T3 M6\nG43 H3\nG0 Z10\n");
  CHECK(program.motions[0].to.z == 10);
  CHECK(assumes(program, "line 2: the length offset is taken to be the length of tool 3"));
  CHECK(last_z("G43 H5\nG0 Z10\n") == 10);
  CHECK(assumes(read_text("G43 H5\nG0 Z10\n"), "the tool in the spindle is taken to be tool 5"));
  CHECK(error_of("T3 M6\nG43 H4\n").find("2:5: error: the length offset of tool 4 while tool 3") ==
        0);
  CHECK(error_of("G43 H5\nG43 H6\n").find("2:5: error: the length offset of tool 6") == 0);
}

TEST_CASE("a T without its M6 loads nothing, and is told", "[unit][gcode]") {
  CHECK(assumes(read_text("T5\nG0 Z10\n"), "line 1: T5 is never loaded, since no M6 follows"));
  CHECK_FALSE(assumes(read_text("T0\nG0 Z10\n"), "never loaded"));
  CHECK_FALSE(assumes(read_text("T5 M6\nG0 Z10\n"), "never loaded"));
  // The next one may be got ready while the first cuts.
  CHECK_FALSE(assumes(read_text("T5 M6\nT6\nG0 Z10\n"), "never loaded"));
}

TEST_CASE("the diameter of another tool is used, and told", "[unit][gcode]") {
  MachineSetup machine = two_tools();
  machine.tools[0].diameter_mm = 8, machine.tools[1].diameter_mm = 6;
  const std::string head = "G0 X0 Y0 Z0\n", tail = " X10\nG1 X20 F100\nG40 X30 Y10\n";
  const auto told = [&](const std::string& program) {
    return assumes(read_text(program, machine),
                   "the diameter of tool 2 is used for cutter "
                   "compensation while tool 1 is in the spindle");
  };
  CHECK(told("T1 M6\n" + head + "G41 D2" + tail));
  CHECK_FALSE(told("T1 M6\n" + head + "G41 D1" + tail));
  CHECK_FALSE(told("T1 M6\n" + head + "G41" + tail));
  CHECK_FALSE(told("T1 M6\n" + head + "G41.1 D2" + tail));
}

TEST_CASE("G43.1 states the length of a tool whose length is not stated", "[unit][gcode]") {
  CHECK(last_z("T3 M6\nG43.1 Z77\nG0 Z10\n") == 10);
  // A second value for the same tool is a difference.
  CHECK(last_z("T3 M6\nG43.1 Z77\nG0 Z10\nG43.1 Z77.5\nZ10\n") == 10.5);
  CHECK(error_of("G43.1 X1 Z2\n").find("1:7: error: a tool offset along X") == 0);
  CHECK(error_of("G0 G43.1 Z2\n").find("1:4: error: G43.1 and 'G0' would both use") == 0);
}

TEST_CASE("no feed motion under the offset of a tool that is gone", "[unit][gcode]") {
  const std::string start = "T3 M6 G43 H3\nG0 X0 Y0 Z10\nG1 Z0 F100\nG0 Z10\nT4 M6\n";
  CHECK(error_of(start + "G0 X5\nG43 H4 Z10\nG1 Z0\n") == "no error");
  CHECK(error_of(start + "G0 X5\nG1 Z0\n")
            .find("7:1: error: a feed motion under a length offset "
                  "that is not that of tool 4") == 0);
  CHECK(error_of(start + "G49\nG1 Z0\n").find("7:1: error: a feed motion under") == 0);
  CHECK(error_of("T3 M6\nG1 Z0 F1\nT4 M6\nG1 Z1\n") == "no error");
}

TEST_CASE("tool changes are kept with the motion behind them", "[unit][gcode]") {
  const Program program = read_text("G0 X1\nT1 M6\nG0 X2\nX3\nT2\nT1 M6\nT2 M6\nX4\n");
  REQUIRE(program.tool_changes.size() == 2);
  CHECK(program.tool_changes[0].line == 2);
  CHECK(program.tool_changes[0].motion == 1);
  CHECK(program.tool_changes[0].tool == 1);
  CHECK(program.tool_changes[1].line == 7);
  CHECK(program.tool_changes[1].motion == 3);
  CHECK(program.tool_changes[1].tool == 2);
  CHECK(error_of("M6\n").find("1:1: error: a tool change without a tool") == 0);
}

TEST_CASE("the tool at the start is the one stated, or the only one", "[unit][gcode]") {
  MachineSetup machine = two_tools();
  CHECK(read_text("G0 X1\n", machine).tool_changes.empty());
  machine.loaded_tool = 2;
  const Program program = read_text("G0 Z100\n", machine);
  REQUIRE(program.tool_changes.size() == 1);
  CHECK(program.tool_changes[0].line == 0);
  CHECK(program.tool_changes[0].tool == 2);
  CHECK(program.motions[0].to.z == 20);
  machine.loaded_tool.reset();
  machine.tools.pop_back();
  CHECK(read_text("G0 X1\n", machine).tool_changes.at(0).tool == 1);
}

TEST_CASE("cutter compensation takes a stated diameter", "[unit][gcode]") {
  const std::string start = "T1 M6 G43 G21\nG0 X0 Y0 Z0 F10\n";
  const auto second = [&](const std::string& code) {
    return read_text(start + code + "\nG1 X10\nY10\nG40 X20\n", two_tools()).motions.at(1).to.y;
  };
  CHECK(second("G41") == 3);
  CHECK(second("G42") == -3);
  CHECK(second("G41 D1") == 3);
  CHECK(second("G41 D0") == 3);
  CHECK(second("G41.1 D4") == 2);
  CHECK(error_of(start + "G41 D2\n", two_tools())
            .find("3:5: error: cutter compensation by the diameter of tool 2, which nothing") == 0);
  CHECK(error_of(start + "G41.1\n", two_tools()).find("3:1: error: 'G41.1' without its") == 0);
  CHECK(error_of(start + "G19 G41\n", two_tools()).find("3:5: error: cutter compensation in G19") ==
        0);
}

TEST_CASE("compensation forbids changes of frame", "[unit][gcode]") {
  const std::string start = "T1 M6 G43\nG0 X0 Y0 Z0 F10\nG41\nG1 X10\n";
  for (const char* code :
       {"G54", "G55", "G92 X0", "G52 X1", "G92.1", "G10 L2 P1 X5", "G28", "G30.1", "G43", "G49",
        "G18", "T2 M6", "G53 G0 X0", "G42", "G10 L20 P0 X0"}) {
    CAPTURE(code);
    CHECK(
        error_of(start + code + "\n", two_tools()).find("while cutter compensation is on (G41)") !=
        std::string::npos);
  }
  CHECK(error_of(start + "G10 L2 P2 X5 Y0 Z0\nG1 X20\nG40\n", two_tools()) == "no error");
}

namespace {

/// Two tools, G54 300 mm below the machine's zero, which is its reference point too.
MachineSetup two_tools_of(Control control) {
  MachineSetup machine = two_tools();
  machine.control = control;
  machine.work_offsets[0] = WorkOffset{{0, 0, -300}, 0};
  machine.home_mm = Vec3{0, 0, 0};
  return machine;
}

/// Behind a tool at Z10 with its length in effect; -300 is G54's.
double z_behind(const std::string& text, Control control) {
  return last_z("T1 M6\nG90 G21 G43 H1\nG0 X0 Y0 Z10.\n" + text, two_tools_of(control)) + 300;
}

}  // namespace

TEST_CASE("the tool's length is out of effect behind G28, G30 and G53 on Fanuc until H or G43",
          "[unit][gcode]") {
  for (const std::string code : {"G53 Z0.", "G28 Z20.", "G28", "G28 G91 Z0.\nG90"}) {
    CAPTURE(code);
    CHECK(z_behind(code + "\nZ10.\n", Control::fanuc) == -40);
    CHECK(z_behind(code + "\nH1 Z10.\n", Control::fanuc) == 10);
    CHECK(z_behind(code + "\nG43 Z10.\n", Control::fanuc) == 10);
    CHECK(z_behind(code + "\nZ10.\n", Control::linuxcnc) == 10);
    const Program program =
        read_text("T1 M6\nG90 G21 G43 H1\nG0 X0 Y0 Z10.\n" + code + "\nX1.\nZ10.\nZ11.\n",
                  two_tools_of(Control::fanuc));
    CHECK(assumes(program, "the tool's length is taken to be out of effect since G"));
  }
  // Where Z does not move it stays.
  CHECK(z_behind("G53 X0.\nZ10.\n", Control::fanuc) == 10);
  CHECK(z_behind("G28 X0.\nZ10.\n", Control::fanuc) == 10);
  CHECK(!assumes(read_text("T1 M6\nG90 G21 G43 H1\nG0 X0 Y0 Z10.\nG53 Z0.\nX5.\nG43 H1 Z10.\n",
                           two_tools_of(Control::fanuc)),
                 "out of effect"));
}

TEST_CASE("the tool's length is out of effect behind G28 on Haas, and not behind G53",
          "[unit][gcode]") {
  CHECK(z_behind("G28 Z20.\nZ10.\n", Control::haas) == -40);
  CHECK(z_behind("G28 X0.\nZ10.\n", Control::haas) == -40);
  CHECK(z_behind("G28 Z20.\nG43 H1 Z10.\n", Control::haas) == 10);
  CHECK(z_behind("G53 Z0.\nZ10.\n", Control::haas) == 10);
}

TEST_CASE("no feed motion where G28 has taken an unstated length out of effect", "[unit][gcode]") {
  MachineSetup machine;
  machine.control = Control::fanuc;
  const std::string start = "T1 M6\nG90 G21 G43 H1\nG0 X0 Y0 Z10.\nG91 G28 Z0.\nG90\nX0. Y0.\n";
  CHECK(error_of(start + "Z5.\nG1 Z0. F100.\n", machine)
            .find("8:1: error: a feed motion while the length of tool 1 is out of effect since "
                  "G28") == 0);
  CHECK(error_of(start + "G43 H1 Z5.\nG1 Z0. F100.\n", machine) == "no error");
}

TEST_CASE("Z in G91 behind a change of the length is refused where the control adds the change",
          "[unit][gcode]") {
  const auto error = [](const std::string& text, Control control) {
    return error_of("T1 M6\nG90 G21 G0 X0 Y0\n" + text, two_tools_of(control));
  };
  for (const Control control : {Control::fanuc, Control::haas}) {
    CHECK(error("G91 G28 Z0.\nG43 H1 Z-200.\n", control).find("4:8: error: 'Z-200.' in G91") == 0);
    CHECK(error("G43 H1\nG91 Z-5.\n", control).find("4:5: error: 'Z-5.' in G91") == 0);
    CHECK(error("G43 H1\nG91 G81 Z-5. R-3. F100.\n", control).find("4:9: error: 'Z-5.' in G91") ==
          0);
    CHECK(error("G43 H1 Z5.\nG91 Z-5.\nG49\nG28 Z0.\nG90 Z3.\n", control) == "no error");
  }
  CHECK(error("G43 H1\nG91 Z-5.\n", Control::linuxcnc) == "no error");
}

TEST_CASE("G28 of an axis that stays where it is leaves the length in effect", "[unit][gcode]") {
  CHECK(z_behind("G28 A0.\nZ10.\n", Control::fanuc) == 10);
  const MachineSetup machine = [] {
    MachineSetup out = two_tools_of(Control::fanuc);
    out.second_home_mm = Vec3{0, 0, -10};
    return out;
  }();
  const std::string start = "T1 M6\nG90 G21 G43 H1\nG0 X0 Y0 Z10.\n";
  CHECK(end_of_text(start + "G91 G30 P2 Z0.\n", machine).z == -60);
  CHECK(error_of(start + "G91 G30 P3 Z0.\n", machine).find("4:9: error: 'P3' beside G30") == 0);
}
