#include "model/gcode/program_path.h"
#include "tests/model/gcode/read_text.h"
#include "tests/model/gcode/turning/turning_machines.h"
#include "tests/support/catch.h"

namespace limitgauge::model {
namespace {

using namespace test;

constexpr double kSame_mm = 1e-9;  // roundings of places turned back and forth

MachineSetup three_axes() {
  MachineSetup machine;
  machine.tools = {{1, 80, 6}, {2, 100, 6}};
  machine.work_offsets[0] = WorkOffset{{0, 0, -200}, 0};
  machine.start_mm = Vec3{0, 0, 100};
  return machine;
}

MachineSetup with_two_tools(MachineSetup machine) {
  machine.tools.push_back({2, 100, 6});
  return machine;
}

Toolpath path_from(const Program& program, std::size_t first, const MachineSetup& machine) {
  PathOptions options;
  options.start_mm = machine.work_offsets[0].value().origin_mm + machine.start_mm.value();
  options.first = first;
  return to_toolpath(program, options);
}

/// A motion to where the tool stands names the place that its tip has come to: so does the path
/// begin there without it.
void check_change(const std::string& before, const MachineSetup& machine) {
  CAPTURE(before);
  const std::string change = "T2 M6\n", stay = "G91 G0 X0\nG90\n", then = "G43 H2\nG0 X77\n";
  const Program still = read_text(before + change + stay + then, machine);
  const Program plain = read_text(before + change + then, machine);
  PathOptions options = turning_options(machine);
  options.first = plain.tool_changes.back().motion;
  REQUIRE(plain.motions.size() == options.first + 1);
  const TurningPath known = to_turning_path(still, options), made = to_turning_path(plain, options);
  CHECK(distance(made.path.start, known.path.moves.at(0).to) < kSame_mm);
  CHECK(distance(made.path.moves.back().to, known.path.moves.back().to) < kSame_mm);
  const Toolpath tip = tip_path(plain, options), known_tip = tip_path(still, options);
  CHECK(distance(tip.start, known_tip.moves.at(0).to) < kSame_mm);
  // Of the whole program the change stands between its motions.
  options.first = 0;
  const TurningPath whole = to_turning_path(plain, options);
  const Move& changed = whole.path.moves.at(whole.path.moves.size() - 2);
  CHECK(distance(changed.to, made.path.start) < kSame_mm);
  CHECK(changed.kind == MoveKind::rapid);
  CHECK(changed.spindle_stopped);
}

}  // namespace

TEST_CASE("a longer tool begins lower than the one before has ended", "[unit][gcode]") {
  const MachineSetup machine = three_axes();
  const Program program =
      read_text("T1 M6\nG43\nG0 X0 Y0 Z50\nT2 M6\nG43\nG1 X100 F500\n", machine);
  REQUIRE(program.tip_places.size() == 1);
  CHECK(program.tip_places[0].motion == 1);
  CHECK(program.tip_places[0].line == 4);
  const Toolpath path = path_from(program, 1, machine);
  CHECK(path.start == Vec3{0, 0, -170});
  REQUIRE(path.moves.size() == 1);
  CHECK(path.moves[0].to == Vec3{100, 0, -170});
}

TEST_CASE("the first tool stands as far below the spindle as it is long", "[unit][gcode]") {
  const MachineSetup machine = three_axes();
  const Program program = read_text("G53 G0 Z0\nT1 M6\nG0 X100 Y0\nG43 H1 Z60\n", machine);
  const Toolpath path = path_from(program, 0, machine);
  REQUIRE(path.moves.size() == 4);
  CHECK(path.moves[0].to == Vec3{0, 0, 0});
  CHECK(path.moves[1].to == Vec3{0, 0, -80});
  CHECK(path.moves[2].to == Vec3{100, 0, -80});
  CHECK(path.moves[3].to == Vec3{100, 0, -140});
  CHECK(assumes(program, "line 2: the tool before T1, whose length nothing states"));
}

TEST_CASE("an empty spindle is followed as if the tool before were there", "[unit][gcode]") {
  const MachineSetup machine = three_axes();
  const std::string begin = "T1 M6\nG43\nG0 X0 Y0 Z50\nT0 M6\nG0 X10\nX0\n";
  const Program other = read_text(begin + "T2 M6\nG43 H2\nG1 X100 F500\n", machine);
  CHECK(other.motions[1].to == Vec3{10, 0, -150});
  CHECK(other.motions.back().to == Vec3{100, 0, -170});
  CHECK(path_from(other, 3, machine).start == Vec3{0, 0, -170});
  const Program same = read_text(begin + "T1 M6\nG1 X100 F500\n", machine);
  CHECK(same.tip_places.empty());
  CHECK(same.motions.back().to == Vec3{100, 0, -150});
}

TEST_CASE("a tool of a length that nothing states begins where the one before ended",
          "[unit][gcode]") {
  const MachineSetup machine = three_axes();
  const Program program = read_text("T1 M6\nG0 X0 Y0 Z50\nT7 M6\nG0 X9\nG43 H7\nG0 X5\n", machine);
  CHECK(program.tip_places.empty());
  CHECK(program.motions[1].to == Vec3{9, 0, -230});
  CHECK(program.motions[2].to == Vec3{5, 0, -230});
}

TEST_CASE("a length that only the program says is held against that of the tool before",
          "[unit][gcode]") {
  MachineSetup machine = three_axes();
  machine.tools.clear();
  for (const bool in_block : {true, false}) {
    const auto offset = [&](const std::string& tool, const std::string& length) {
      if (in_block) return "G43.1 Z" + length + "\n";
      return "G10 L1 P" + tool + " Z" + length + "\nG43 H" + tool + "\n";
    };
    const Program program =
        read_text("T1 M6\n" + offset("1", "80") + "G0 X0 Y0 Z50\nT2 M6\n" + offset("2", "100") +
                      "G0 X10\nT1 M6\n" + offset("1", "80") + "G0 X100\n",
                  machine);
    CHECK(program.motions[0].to.z == -150);
    CHECK(program.motions[1].to.z == -170);
    CHECK(program.motions[2].to.z == -150);
    REQUIRE(program.tip_places.size() == 2);
    CHECK(program.tip_places[0].at_mm == Vec3{0, 0, -170});
    CHECK(program.tip_places[1].at_mm == Vec3{10, 0, -150});
  }
}

TEST_CASE("a tool that no number names, an empty spindle, and a tool of a stated length",
          "[unit][gcode]") {
  const MachineSetup machine = three_axes();
  const Program program =
      read_text("G43.1 Z80\nG0 X0 Y0 Z50\nT0 M6\nG0 X5\nG0 Z50\nT2 M6\nG43 H2\nG0 X100\n", machine);
  CHECK(program.motions[1].to.z == -150);
  CHECK(program.motions[2].to.z == -150);
  CHECK(program.motions[3].to.z == -170);
}

TEST_CASE("a tool of no known length before one of a stated length is taken to have none",
          "[unit][gcode]") {
  const MachineSetup machine = three_axes();
  const std::string begin = "T9 M6\nG43\nG0 X0 Y0 Z50\n";
  for (const std::string offset : {"", "G43\n"}) {
    const Program program = read_text(begin + "T2 M6\n" + offset + "G0 X100\n", machine);
    CHECK(program.motions[1].to.z == -250);
    CHECK(assumes(program, "line 4: the tool before T2, whose length nothing states"));
  }
  // Between two whose lengths are known it is as long as the first.
  const Program between =
      read_text("T1 M6\nG43\nG0 X0 Y0 Z50\nT9 M6\nG43\nG0 X9\nT2 M6\nG43\nG0 X7\n", machine);
  CHECK(between.motions[1].to.z == -150);
  CHECK(between.motions[2].to.z == -170);
}

TEST_CASE("another tool's tip on machines that turn it, whatever the control keeps",
          "[unit][gcode]") {
  for (const MachineSetup& machine :
       {with_two_tools(turning_trunnion(Control::linuxcnc)), with_two_tools(turning_trunnion())})
    for (const std::string turn : {"", "G0 A40\n", "G0 A40 C70\n", "G0 C90\n"})
      for (const std::string move : {"", "G0 Y12\n"})
        check_change(kApproach + turn + move, machine);
  for (const MachineSetup& machine :
       {with_two_tools(turning_heads()), with_two_tools(turning_head_table())})
    for (const std::string turn : {"G0 B90\n", "G0 B-35 C70\n"})
      for (const std::string move : {"", "G0 Y12\n"})
        check_change(kApproach + turn + move, machine);
}

TEST_CASE("another tool's tip in a head that lies along X", "[unit][gcode]") {
  // B at 90: the spindle's end stands at (100, 0, 130), the tools point from there towards -X.
  MachineSetup machine = three_axes();
  machine.control = Control::fanuc;
  machine.work_offsets[0] = WorkOffset{};
  machine.kinematics =
      Kinematics{MachineKind::head_head, {{'B', {0, 1, 0}, {}, -120, 120}, {'C', {0, 0, 1}, {}}}};
  const std::string begin =
      "G21 G90 G94 G17 G40\nT1 M6\nG43 H1\nG0 X100. Y0. Z50.\nB90.\nY-1.\nY0.\n";
  const Program program = read_text(begin + "T2 M6\nG0 Y100.\n", machine);
  REQUIRE(program.tip_places.size() == 1);
  CHECK(distance(program.tip_places[0].at_mm, {0, 0, 130}) < kSame_mm);
  PathOptions options;
  options.kinematics = machine.kinematics;
  options.start_mm = Vec3{0, 0, 100};
  options.reach_mm = 40;
  options.first = program.tip_places[0].motion;
  const TurningPath made = to_turning_path(program, options);
  CHECK(distance(made.path.start, {0, 0, 130}) < kSame_mm);
  CHECK(distance(made.path.moves.back().to, {0, 100, 130}) < kSame_mm);
}

TEST_CASE("another tool's tip under tip control", "[unit][gcode]") {
  const MachineSetup trunnion = with_two_tools(turning_trunnion(Control::linuxcnc));
  for (const std::string turn : {"G0 A40\n", "G0 A90 C30\n"})
    for (const std::string move : {"", "G0 Y12 Z7\n"})
      check_change("G21 G90 G94 G43\nG0 X0 Y0 Z100\nM428\n" + turn + move, trunnion);
}

TEST_CASE("a length offset under tip control leaves the tip where it is", "[unit][gcode]") {
  // A at 90: the tool lies along the part's Y, along which its tip is 20 mm further back.
  const MachineSetup machine = with_two_tools(turning_trunnion(Control::linuxcnc));
  const std::string begin = "G21 G90 G94 G43\nG0 X0 Y0 Z100\nA90\nM428\nG0 X0 Y50 Z0\n";
  PathOptions options = turning_options(machine);
  const auto ends = [&](const std::string& then) {
    return to_turning_path(read_text(begin + then, machine), options).path.moves.back().to;
  };
  const Vec3 still = ends(""), offset = ends("G43 H2\nG91 G0 X0\n"),
             none = ends("G49\nG91 G0 X0\n");
  CHECK(distance(still, offset) < kSame_mm);
  CHECK(distance(still, none) < kSame_mm);
  // What is named in G90 is another place then.
  CHECK(distance(ends("G43 H2\nG0 X0 Y50 Z0\n"), still) == Approx(20));
}

}  // namespace limitgauge::model
