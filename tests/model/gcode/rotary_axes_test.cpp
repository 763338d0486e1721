#include "model/gcode/program_path.h"
#include "tests/model/gcode/read_text.h"
#include "tests/support/catch.h"

using namespace limitgauge::model;
using namespace limitgauge::model::test;

namespace {

constexpr double kStandRounding_mm = 1e-9;

/// A trunnion: C on A, both off the machine's zero.
MachineSetup trunnion(Control control = Control::fanuc) {
  MachineSetup machine;
  machine.control = control;
  machine.tools = {{1, 80, 6}};
  machine.loaded_tool = 1;
  machine.work_offsets[0] = WorkOffset{{10, 20, -30}, 0};
  machine.start_mm = Vec3{0, 0, 200};
  machine.kinematics = Kinematics{
      MachineKind::table_table,
      {{'A', {1, 0, 0}, {3, -7, -60}, -120, 120}, {'C', {0, 0, 1}, {5, 2, -30}, -720, 720}}};
  return machine;
}

MachineSetup swivel_head() {
  MachineSetup machine = trunnion();
  machine.kinematics = Kinematics{
      MachineKind::head_head,
      {{'C', {0, 0, 1}, {0, 0, 200}, -360, 360}, {'B', {0, 1, 0}, {0, 1, 150}, -110, 110}}};
  return machine;
}

/// Where the program's last motion leaves the tip, in the workpiece as it lies with all axes at 0,
/// in the machine's frame.
ToolStand stand_at_end(const std::string& text, const MachineSetup& machine) {
  const Program program = read_text(text, machine);
  const Kinematics& kinematics = *machine.kinematics;
  if (!program.turns.empty() && program.turns.back().motion + 1 == program.motions.size()) {
    const Pose tool = program.turns.back().turn.tool_at(kinematics, 1);
    return {tool.shift_mm, tool.direction({0, 0, 1})};
  }
  const FrameChange& last = program.frames.back();
  return {last.frame.in_workpiece(kinematics, last.angles_deg).point(program.motions.back().to),
          kinematics.stand({}, last.angles_deg, 0).axis};
}

void check_tool(const ToolStand& stand, const Vec3& tip_mm, const Vec3& axis) {
  CAPTURE(stand.tip_mm.x, stand.tip_mm.y, stand.tip_mm.z, stand.axis.x, stand.axis.y, stand.axis.z);
  CHECK(distance(stand.tip_mm, tip_mm) < kStandRounding_mm);
  CHECK(distance(stand.axis, axis) < kStandRounding_mm);
}

const std::string kBegin = "G21 G90 G43 H1\nG0 X0 Y0 Z100\n";

}  // namespace

TEST_CASE("X, Y and Z are joints until something says otherwise", "[unit][gcode]") {
  const MachineSetup machine = trunnion();
  // The tip stays at (11, 22, 73) of the machine; about A, and then back about it.
  const ToolStand stand = stand_at_end(kBegin + "G0 X1 Y2 Z103 A90\n", machine);
  const Vec3 seen = Vec3{11, 22, 73} - Vec3{3, -7, -60};
  check_tool(stand, Vec3{3, -7, -60} + Vec3{seen.x, seen.z, -seen.y}, {0, 1, 0});
}

TEST_CASE("with tool-centre control places are the tip's in the workpiece", "[unit][gcode]") {
  for (const char* turn : {"A30 C70", "A-90 C0", "A0 C180"}) {
    const std::string text = kBegin + "G0 " + turn + "\nG43.4 H1\nG0 X1 Y2 Z3\n";
    const ToolStand stand = stand_at_end(text, trunnion());
    CHECK(distance(stand.tip_mm, {11, 22, -27}) < kStandRounding_mm);
    // A turn keeps the tip in its place then.
    CHECK(distance(stand_at_end(text + "G1 F100 A10 C5\n", trunnion()).tip_mm, {11, 22, -27}) <
          kStandRounding_mm);
  }
  const std::string haas = kBegin + "G0 A30 C70\nG234 H1\nG0 X1 Y2 Z3\n";
  CHECK(distance(stand_at_end(haas, trunnion(Control::haas)).tip_mm, {11, 22, -27}) <
        kStandRounding_mm);
  const std::string linuxcnc = "G21 G90 G43\nG0 A30 C70\nM428\nG0 X1 Y2 Z3\n";
  CHECK(distance(stand_at_end(linuxcnc, trunnion(Control::linuxcnc)).tip_mm, {11, 22, -27}) <
        kStandRounding_mm);
}

TEST_CASE("under G43.5 I, J and K are the tool's axis", "[unit][gcode]") {
  const std::string begin = kBegin + "G43.5 H1\nG1 F100 X1 Y2 Z3\n";
  for (const MachineSetup& machine : {trunnion(), swivel_head()}) {
    const Vec3 axis = normalized(Vec3{0.3, -0.4, 1});
    // Of any length; what is left out is 0.
    check_tool(stand_at_end(begin + "X4 I0.6 J-0.8 K2.\n", machine), {14, 22, -27}, axis);
    check_tool(stand_at_end(begin + "I0.6 J-0.8 K2.\n", machine), {11, 22, -27}, axis);
    check_tool(stand_at_end(begin + "G0 Y5 J-0.5 K.5\n", machine), {11, 25, -27},
               normalized(Vec3{0, -1, 1}));
    // All left out: as it stands; and behind G49 they are no longer read.
    check_tool(stand_at_end(begin + "X4 I.3 J-.4 K1.\nX5\n", machine), {15, 22, -27}, axis);
  }
  // The same turn as by the angles themselves, the nearest of the ways.
  const Program by_vector = read_text(begin + "X4 J1. K1.\n", trunnion());
  const Program by_angles = read_text(kBegin + "G43.4 H1\nG1 F100 X1 Y2 Z3\nX4 A45\n", trunnion());
  REQUIRE(by_vector.turns.size() == 1);
  REQUIRE(by_angles.turns.size() == 1);
  for (std::size_t i = 0; i < 3; ++i)
    CHECK(std::abs(by_vector.turns[0].turn.to_deg[i] - by_angles.turns[0].turn.to_deg[i]) < 1e-9);
  CHECK(distance(by_vector.turns[0].turn.to_mm, by_angles.turns[0].turn.to_mm) < 1e-9);
  CHECK(assumes(by_vector, "line 3: I, J and K under G43.5 are taken to turn the axes"));
}

TEST_CASE("the ends of all modes leave the tool where it stands", "[unit][gcode]") {
  for (const char* modes :
       {"G43.4 H1\nG0 X1 Y2 Z3\nG49\n", "G68.2 X1 Y2 Z3 I10 J20 K30\nG0 X1 Y2 Z3\nG69\n"}) {
    const std::string text = kBegin + "G0 A30 C70\n" + modes;
    const ToolStand within = stand_at_end(text, trunnion());
    const ToolStand after = stand_at_end(text + "G43 H1\nG91 G0 X0\n", trunnion());
    check_tool(after, within.tip_mm, within.axis);
  }
  const std::string haas = kBegin + "G0 A30 C70\nG254\nG0 X1 Y2 Z3\n";
  const ToolStand within = stand_at_end(haas, trunnion(Control::haas));
  check_tool(stand_at_end(haas + "G255\nG91 G0 X0\n", trunnion(Control::haas)), within.tip_mm,
             within.axis);
}

TEST_CASE("a dynamic offset counts along the machine's axes from where the zero has gone",
          "[unit][gcode]") {
  const MachineSetup machine = trunnion(Control::haas);
  const ToolStand stand = stand_at_end(kBegin + "G0 C90\nG254\nG0 X1 Y2 Z3\n", machine);
  // Along the workpiece's axes, which a quarter about C has turned, by (2, -1, 3).
  check_tool(stand, Vec3{10, 20, -30} + Vec3{2, -1, 3}, {0, 0, 1});
}

TEST_CASE("a tilted plane has its own zero and axes, and G53.1 puts the tool along Z of it",
          "[unit][gcode]") {
  const std::string plane = kBegin + "G68.2 X1 Y2 Z3 I0 J-90 K0\nG53.1\n";
  for (const MachineSetup& machine : {trunnion(), swivel_head()}) {
    // Turned by -90 about X, Y points down and Z along Y.
    check_tool(stand_at_end(plane + "G0 X4 Y5 Z6\n", machine),
               Vec3{10, 20, -30} + Vec3{1 + 4, 2 + 6, 3 - 5}, {0, 1, 0});
  }
  const Program program = read_text(plane, trunnion());
  REQUIRE(program.turns.size() == 1);
  CHECK(program.turns[0].turn.to_deg == RotaryAngles{90, 0, 0});
  CHECK(assumes(program, "line 4: G53.1 is taken to turn to A90 C0"));
  // G53.1 leaves X, Y and Z of the machine alone.
  CHECK(program.turns[0].turn.from_mm == program.turns[0].turn.to_mm);
}

TEST_CASE("a head takes the tip with it by the tool's length", "[unit][gcode]") {
  // At 100 above the work's zero the gauge point is at 70 + 80; the axis 150 above it and 1 aside.
  const ToolStand stand = stand_at_end(kBegin + "G0 B90\n", swivel_head());
  check_tool(stand, {10 - 150 - 80, 20, 150 + 150}, {1, 0, 0});
  MachineSetup unknown = swivel_head();
  unknown.tools = {{1, std::nullopt, 6}};
  CHECK(error_of("G21 G90\nG0 X0 Y0 Z100\nB90\n", unknown).find("is not stated") !=
        std::string::npos);
}

TEST_CASE("reference points of rotary axes are at 0", "[unit][gcode]") {
  const std::string text = kBegin + "G0 A30 C70\n";
  const Program program = read_text(text + "G91 G28 Z0\nG28 A0 C0\n", trunnion());
  CHECK(program.turns.back().turn.to_deg == RotaryAngles{});
  CHECK(program.turns.back().parked);
  CHECK(assumes(program, "the reference points of the rotary axes are taken to be at 0"));
  const Program all = read_text(text + "G91 G28 Z0\nG28\n", trunnion());
  CHECK(all.turns.back().turn.to_deg == RotaryAngles{});
  CHECK(read_text(text + "G28 Z300\n", trunnion()).turns.size() == 1);
}

TEST_CASE("axes that go home beside Z turn while it is on its way", "[unit][gcode]") {
  MachineSetup machine = trunnion();
  machine.home_mm = Vec3{0, 0, 400};
  const std::string text = kBegin + "G0 A30 C70\nZ5\n";
  for (const std::string home : {"G91 G28 Z0 A0\n", "G53 G0 Z0 A0\n"}) {
    CAPTURE(home);
    const Program program = read_text(text + home, machine);
    const AxisTurn& turn = program.turns.back();
    CHECK(turn.turn.from_deg == RotaryAngles{30, 0, 70});
    CHECK(turn.turn.to_deg == RotaryAngles{0, 0, 70});
    CHECK_FALSE(turn.parked);
    CHECK(std::abs(turn.turn.to_mm.z - turn.turn.from_mm.z) > 50);
  }
  // Where nothing states how high that is, what they may meet is not known either.
  machine = trunnion();
  machine.work_offsets = {};
  for (const std::string home : {"G91 G28 Z0 A0\n", "G28\n", "G53 G0 Z0 A0\n"}) {
    CAPTURE(home);
    CHECK_THAT(error_of(text + home, machine),
               ContainsSubstring("axes turn while Z is sent to a place that nothing states"));
    CHECK(read_text(text + "G91 G28 Z0\nG90\n" + home, machine).turns.back().parked);
  }
}

TEST_CASE("before Z is named it is taken to stand above everything while axes turn",
          "[unit][gcode]") {
  MachineSetup machine = trunnion();
  machine.start_is_assumed = true;
  const Program program = read_text("G21 G90\nG0 A30\nX0 Y0 Z50\nA0\n", machine);
  REQUIRE(program.turns.size() == 2);
  CHECK(program.turns[0].parked);
  CHECK_FALSE(program.turns[1].parked);
  CHECK(assumes(program, "line 2: an axis turns while Z is taken to stand above everything"));
  CHECK_FALSE(read_text("G21 G90\nG0 A30\n", trunnion()).turns[0].parked);
}

TEST_CASE("Z that was moved before it was named stands where it was moved to while axes turn",
          "[unit][gcode]") {
  MachineSetup machine = trunnion();
  machine.start_is_assumed = true;
  const std::string down = "G21 G91\nG0 Z-50\nG1 Z-5 F100\n";
  CHECK_FALSE(read_text(down + "G90 G0 A30\n", machine).turns[0].parked);
  CHECK(read_text("G21 G91\nG0 X5\nG90 A30\n", machine).turns[0].parked);
}

TEST_CASE("LinuxCNC's parameters say where the rotary axes stand", "[unit][gcode]") {
  // X is the parameter's value.
  const auto value = [](const std::string& parameter) {
    const Program program =
        read_text(kBegin + "M429\nG0 A-30 C70\nG28.1\nG0 A10\nX[" + parameter + "]\n",
                  trunnion(Control::linuxcnc));
    return program.motions.back().to.x - trunnion().work_offsets[0]->origin_mm.x;
  };
  const double none = value("0");
  for (const char* a : {"#5423", "#5024", "#<_a>", "#<_abs_a>"}) {
    CAPTURE(a);
    CHECK(value(a) - none == Approx(10));
  }
  for (const char* c : {"#5425", "#5026", "#<_c>", "#<_abs_c>"}) {
    CAPTURE(c);
    CHECK(value(c) - none == Approx(70));
  }
  CHECK(value("#5164") - none == Approx(-30));
  CHECK(value("#5424") == none);
}

TEST_CASE("G28 turns to where G28.1 found the rotary axes", "[unit][gcode]") {
  for (const std::string number : {"28", "30"}) {
    const Program program =
        read_text(kBegin + "G0 A30 C20\nG" + number + ".1\nG0 A0 C0\nG" + number + "\n",
                  trunnion(Control::linuxcnc));
    CHECK(program.turns.back().turn.to_deg == RotaryAngles{30, 0, 20});
    CHECK_FALSE(assumes(program, "the reference points of the rotary axes are taken to be at 0"));
  }
}

TEST_CASE("stretches between turns take every motion once", "[unit][gcode]") {
  const Program program = read_text(kBegin + "G0 A30\nC70\nX1\nX2\nA0\nX3\nA90 C0\n", trunnion());
  const auto ranges = steady_ranges(program, 0, program.motions.size());
  REQUIRE(ranges.size() == 4);
  CHECK(ranges[0].turns.empty());
  CHECK(ranges[1].turns.size() == 2);
  CHECK(ranges[1].angles_deg == RotaryAngles{30, 0, 70});
  CHECK(ranges[1].last - ranges[1].first == 2);
  CHECK(ranges[2].angles_deg == RotaryAngles{0, 0, 70});
  CHECK(ranges[3].first == ranges[3].last);
  CHECK(ranges[3].turns.size() == 1);
}

TEST_CASE("what is not carried out with rotary axes is said at its word", "[unit][gcode]") {
  const auto error = [](const std::string& text, Control control = Control::fanuc) {
    return error_of(kBegin + text, trunnion(control));
  };
  const auto holds = [](const std::string& text, const std::string& part) {
    CAPTURE(text);
    return text.find(part) != std::string::npos;
  };
  CHECK(holds(error("G68.2 J30\nG2 X1 I1 F9 A90\n"), "turns an axis on an arc while a working"));
  CHECK(holds(error("G81 X1 Z-1 R2 F100 A90\n"), "canned cycle"));
  CHECK(holds(error("B90\n"), "of a rotary axis that the machine lacks"));
  CHECK(holds(error("G53.1\n"), "G53.1 without a tilted working plane"));
  CHECK(holds(error("G68.2 I0 J170 K0\nG53.1\n"), "no angles of the rotary axes within their"));
  CHECK(holds(error("G68.2 J30\nG54\n"), "G69 before it"));
  CHECK(holds(error("G68.2 J30\nG0 X1 A30\n"), "beside X, Y or Z while a working plane"));
  CHECK(holds(error("G92 A5\n"), "an offset of a rotary axis"));
  CHECK(holds(error("G254\nG0 A5\n", Control::haas), "G255 before it"));
  for (const char* code : {"G43.4 H1\n", "G43.5 H1\n", "G68.2 J30\n", "G53.1\n"})
    CHECK(holds(error(code, Control::haas), "is Fanuc's, and Haas has"));
  CHECK(holds(error("G43.4 H1\nG0 A30\nG43 H1\n"), "G49 before it"));
  CHECK(holds(error("G43.5 H1\nG1 F9 X1 A30\n"), "G43.4 in place of G43.5"));
  CHECK(holds(error("G43.5 H1\nG2 F9 X1 I1\n"), "R for the arc's radius"));
  CHECK(holds(error("G43.5 H1\nG1 F9 I0 J0 K0\n"), "are no direction"));
  CHECK(holds(error("G43.5 H1\nG1 F9 K-1\n"), "no angles of the rotary axes within their"));
  CHECK(holds(error("G43.5 H1 I0 K1\n"), "beside no code that uses it"));
  CHECK(holds(error("G43.5 H1 Q5\n"), "beside no code that uses it"));
  CHECK(holds(error("G43.5 H1\nG49 G1 F9 X1 K1\n"), "a block of its own behind it"));
  CHECK(holds(error("G1 F9 X1 K1\n"), "beside no code that uses it"));
  CHECK(holds(error("G12.1 P1\n", Control::linuxcnc), "M428 and M429"));
  CHECK(holds(error("G12.1\n", Control::fanuc), "polar coordinate interpolation"));
  CHECK(holds(error("M430\n", Control::linuxcnc), "M430 switches to kinematics"));
  CHECK(holds(error("G0 A2000000\n", Control::linuxcnc), "turns an axis"));
  CHECK(holds(error_of(kBegin + "G43.4 H1\n",
                       [] {
                         MachineSetup machine = trunnion();
                         machine.kinematics.reset();
                         return machine;
                       }()),
              "has no rotary axes"));
}

TEST_CASE("what stands at 0 moves nothing, whatever the machine", "[unit][gcode]") {
  const std::string text = kBegin + "G1 X1 F100\nG2 X3 I1\nG0 A0 Z5\nG43.4 H1\nG1 X7\nG49\n";
  const Program turning = read_text(text, trunnion());
  CHECK(turning.turns.empty());
  PathOptions options;
  options.kinematics = trunnion().kinematics;
  options.machine_in_part = machine_in_part({}, *trunnion().work_offsets[0]);
  const Toolpath path = to_toolpath(turning, options);
  CHECK(path.moves.back().to == Vec3{7, 0, 5});
}
