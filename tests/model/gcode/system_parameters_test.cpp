#include "tests/model/gcode/read_text.h"
#include "tests/support/catch.h"

using namespace limitgauge::model;
using namespace limitgauge::model::test;

namespace {

/// The value of an expression behind `text`.
double value_of(const std::string& text, const std::string& expression,
                const MachineSetup& machine = {}) {
  const std::string plain = "G21 G90 G54 G49 G92.1\nG10 L2 P1 X0 Y0 Z0 R0\n";
  return end_of_text(text + "#100 = [" + expression + "]\n" + plain + "G0 X#100\n", machine).x;
}

bool is_unset(const std::string& text, const std::string& parameter) {
  const std::string error = error_of(text + "#100 = " + parameter + "\n");
  return error.find("parameter " + parameter + " was never set") != std::string::npos;
}

}  // namespace

TEST_CASE("offsets that the program sets read back", "[unit][gcode]") {
  CHECK(value_of("G10 L2 P2 X1 Y2 Z3 R40\n", "#5241 + 10 * #5242 + 100 * #5243") == 321);
  CHECK(value_of("G10 L2 P2 X1 Y2 Z3 R40\n", "#5250") == 40);
  CHECK(value_of("G20 G10 L2 P2 X1 Y2 Z3\n", "#5241") == 25.4);
  CHECK(value_of("G0 X1 Y2 Z3\nG92 X11 Z0\n", "#5211 + 10 * #5213 + 1000 * #5210") == 1020);
  CHECK(value_of("G0 X1 Y2 Z3\nG92 X11\nG92.2\n", "#5210") == 0);
  CHECK(value_of("G0 X1 Y2 Z3\nG28.1\nX7\nG30.1\n", "#5161 + 10 * #5181") == 71);
  CHECK(value_of("G10 L2 P9 X1 Y2 Z3\nG59.3\n", "#5220") == 9);
  CHECK(is_unset("", "#5161"));
  CHECK(is_unset("", "#5241"));
}

TEST_CASE("the position reads in the units of the program", "[unit][gcode]") {
  CHECK(value_of("G20 G0 X2 Y3 Z4\n", "#5420 + 10 * #5421 + 100 * #5422") == 432);
  CHECK(value_of("G0 X1 Y2 Z3\nG10 L2 P1 X-1\n", "#<_x>") == 2);
  CHECK(value_of("G0 X1 Y2 Z3\nG10 L2 P1 X-1\n", "#<_abs_x>") == 1);
  CHECK(is_unset("G0 X1\n", "#5421"));
  CHECK(is_unset("G0 X1 Y2 Z3\nG91 G28 Z0\nG90\n", "#5422"));
}

TEST_CASE("the tool and the modes read as LinuxCNC numbers them", "[unit][gcode]") {
  MachineSetup machine;
  machine.tools = {{1, 50, 6}, {2, 80, std::nullopt}};
  const std::string start = "G21 G90 T1 M6\nT2\n";
  CHECK(value_of(start, "#5400 + 10 * #5410 + 1000 * #5403", machine) == 50061);
  CHECK(value_of(start, "#<_current_tool> + 10 * #<_selected_tool>", machine) == 21);
  CHECK(value_of("", "#<_metric> + 10 * #<_imperial>") == 1);
  CHECK(end_of_text("G20\nG0 X[#<_metric> + 10 * #<_imperial>]\n").x == 254);
  CHECK(value_of("G18\n", "#<_plane>") == 180);
  CHECK(value_of("G10 L2 P8 X0 Y0 Z0\nG59.2\n", "#<_coord_system>") == 592);
  CHECK(value_of("F120 S30 G98\n", "#<_feed> + 1000 * #<_rpm> + #<_retract_old_z>") == 30121);
  CHECK(value_of("G1 F5 X1\n", "#<_motion_mode>") == 10);
  CHECK(value_of("M8 M3\n", "#<_flood> + 10 * #<_mist> + 100 * #<_spindle_cw>") == 101);
  CHECK(value_of("o1 sub\n#<_level> = #<_call_level>\no1 endsub\no1 call\n", "#<_level>") == 1);
  CHECK(is_unset("", "#5399"));
  CHECK(is_unset("", "#5061"));
}
