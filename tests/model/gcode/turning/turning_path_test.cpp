#include "model/gcode/turning/turning_path.h"

#include <stdexcept>

#include "model/gcode/program_path.h"
#include "tests/model/gcode/read_text.h"
#include "tests/model/gcode/turning/turning_machines.h"
#include "tests/model/gcode/turning/turning_poses.h"
#include "tests/support/catch.h"

namespace limitgauge::model {
namespace {

using namespace test;

/// Where the machine has the tool during motion `turn`, in the part's frame: worked out here from
/// the arc or the straight line that the motion names.
Pose tool_in_part(const Program& program, const PathOptions& options, const AxisTurn& turn,
                  double t) {
  TurningMotion at = turn.turn;
  const Motion& motion = program.motions[turn.motion];
  if (motion.kind == MotionKind::arc)
    at.from_mm = at.to_mm = arc_of(motion, turn.turn.from_mm).point_at(t);
  return pose_of(options.machine_in_part) * at.tool_at(*options.kinematics, t);
}

/// The distance of the tool from a move, a share of the way along it.
double off_mm(const TurningPath& made, std::size_t move, double share, const Pose& tool) {
  const Vec3 from = move_from(made.path, move), to = made.path.moves[move].to;
  return distance(tool.shift_mm, from + (to - from) * share) +
         kReach_mm * distance(axis_of(tool),
                              great_circle(axis_from(made.axes, move), made.axes.to[move], share));
}

/// Within what the path says of itself, at many places of each turn. Moves of one turn are equal
/// parts of it, as long as that is small.
void check_turns(const Program& program, const PathOptions& options, const TurningPath& made) {
  for (const AxisTurn& turn : program.turns) {
    const std::vector<std::size_t> moves = moves_of(made, turn.line);
    REQUIRE_FALSE(moves.empty());
    const auto parts = static_cast<double>(moves.size());
    for (std::size_t k = 0; k < moves.size(); ++k) {
      for (const double share : {0.0, 0.2, 0.5, 0.9, 1.0}) {
        const double t = (static_cast<double>(k) + share) / parts;
        const Pose tool = tool_in_part(program, options, turn, t);
        REQUIRE(off_mm(made, moves[k], share, tool) <= made.path.chord_error_mm + kPoseRounding_mm);
      }
    }
  }
}

TurningPath checked(const std::string& text, const MachineSetup& machine) {
  CAPTURE(text);
  const Program program = read_text(text, machine);
  const PathOptions options = turning_options(machine);
  TurningPath made = to_turning_path(program, options);
  CHECK(made.path.chord_error_mm <= options.chord_error_mm);
  check_turns(program, options, made);
  return made;
}

}  // namespace

TEST_CASE("a tip that the control keeps straight goes straight while tables turn",
          "[unit][gcode]") {
  const TurningPath made =
      checked(kCentred + "G1 X10 Y5 Z3 F500\nX20 Y6 Z2 A12 C15\nX30\nM30\n", turning_trunnion());
  const std::vector<std::size_t> moves = moves_of(made, 5);
  CHECK(moves.size() > 3);
  for (const std::size_t i : moves) {
    CHECK(made.path.moves[i].feed_mm_min == Approx(500));
    CHECK((made.path.moves[i].kind == MoveKind::feed));
  }
  // The work's zero is the machine's (10, 20, -30); a quarter turn and a shift take it to the part.
  CHECK(distance(made.path.moves.back().to, {-26 + 7, 40 + 8, -28 + 9}) < 1e-9);
  CHECK(made.axes.to.back() == made.axes.to[made.axes.to.size() - 2]);
}

TEST_CASE("machines of each kind, their tips kept and not", "[unit][gcode]") {
  const std::string cut = "G1 X10 Y5 Z3 F500\nX20 Y6 Z2 %s C15\nX25 %s\nC-10\nG0 X0 Z20 %s\n";
  const auto with = [&](const std::string& begin, const std::string& word) {
    std::string text = begin + cut;
    for (const char* angle : {"12", "-5", "0"})
      text.replace(text.find("%s"), 2, word + std::string(angle));
    return text;
  };
  for (const std::string& begin : {kApproach, kCentred}) {
    checked(with(begin, "A"), turning_trunnion());
    checked(with(begin, "B"), turning_heads());
    checked(with(begin, "B"), turning_head_table());
  }
}

TEST_CASE("arcs that turn rotary axes are chords that turn evenly", "[unit][gcode]") {
  for (const std::string& begin : {kApproach, kCentred}) {
    checked(begin + "G1 X10 Y0 Z3 F500\nG3 X-10 Z1 I-10 A12 C15\nG2 I10 A0 C30\n",
            turning_trunnion());
    checked(begin + "G1 X10 Y0 Z3 F500\nG18 G3 X-10 I-10 B20\nG17 G2 X10 I10 Z0 C-70\n",
            turning_heads());
  }
}

TEST_CASE("inverse time is kept by the moves of a turn", "[unit][gcode]") {
  const TurningPath made = checked(
      kApproach + "G1 X10 Y5 Z3 F500\nG93\nG1 X20 Y6 A12 C15 F4\nC30 F2\n", turning_trunnion());
  for (const auto& [line, minutes] : {std::pair{5U, 0.25}, {6U, 0.5}}) {
    double sum = 0;
    for (const std::size_t i : moves_of(made, line))
      sum += distance(move_from(made.path, i), made.path.moves[i].to) /
             static_cast<double>(made.path.moves[i].feed_mm_min);
    CHECK(sum == Approx(minutes).epsilon(1e-5));
  }
}

TEST_CASE("a turn alone feeds by degrees a minute", "[unit][gcode]") {
  const TurningPath made = checked(kApproach + "G1 X10 Y5 Z3 F500\nC20 F40\n", turning_trunnion());
  double sum = 0;
  for (const std::size_t i : moves_of(made, 4))
    sum += distance(move_from(made.path, i), made.path.moves[i].to) /
           static_cast<double>(made.path.moves[i].feed_mm_min);
  CHECK(sum == Approx(0.5).epsilon(1e-5));
}

TEST_CASE("where axes stand still the path is that of the stretch, turned back", "[unit][gcode]") {
  const std::string text =
      kApproach +
      "G1 X5 F100\nG3 X-5 I-5\nG0 %s30 C70\nX1 Y2 Z50\nG1 X5\nG2 X9 I2\nG43.4 H1\nG0 X1 Y2 Z3\n"
      "G1 X4 Z2\nG49\nG0 Z100\n%s0 C0\nG68.2 X1 Y2 Z3 I10 J30 K20\nG53.1\nG0 X0 Y0 Z5\n"
      "G1 X4\nG18 G2 X8 I2\nG17 G69\nG0 Z90\n%s0 C0\nX0 Y0 Z100\nM30\n";
  for (const auto& [machine, word] :
       {std::pair{turning_trunnion(), "A"}, {turning_heads(), "B"}, {turning_head_table(), "B"}}) {
    std::string own = text;
    while (own.find("%s") != std::string::npos) own.replace(own.find("%s"), 2, word);
    const Program program = read_text(own, machine);
    PathOptions options = turning_options(machine);
    const auto ranges = steady_ranges(program, 0, program.motions.size());
    CHECK(ranges.size() > 3);
    for (const SteadyRange& range : ranges) {
      options.first = range.first, options.last = range.last;
      const TurningPath turning = to_turning_path(program, options);
      const Pose back =
          turned_part(*machine.kinematics, options.machine_in_part, range.angles_deg).inverse();
      const Toolpath steady = turned(to_toolpath(program, options), back);
      CHECK(distance(turning.path.start, steady.start) < kPoseRounding_mm);
      REQUIRE(turning.path.moves.size() == steady.moves.size());
      for (std::size_t i = 0; i < steady.moves.size(); ++i) {
        CHECK(distance(turning.path.moves[i].to, steady.moves[i].to) < kPoseRounding_mm);
        CHECK(distance(turning.axes.to[i], back.direction({0, 0, 1})) < 1e-12);
      }
    }
  }
}

TEST_CASE("a parked tool turns above everything, whatever lies under it", "[unit][gcode]") {
  MachineSetup machine = turning_trunnion();
  const std::string text =
      kCentred + "G1 X10 Y5 Z3 F500\nX20 A80\nG49\nG91 G28 Z0\nG90\nG0 A-80 C30\nX5\nA0\n";
  const Program program = read_text(text, machine);
  const PathOptions options = turning_options(machine);
  const TurningPath made = to_turning_path(program, options);
  const Pose to_machine = pose_of(options.machine_in_part).inverse();
  for (const std::uint32_t line : {9U, 10U, 11U})
    for (const std::size_t i : moves_of(made, line)) {
      CHECK((made.path.moves[i].kind == MoveKind::rapid));
      // From the ball about everything, wherever the tool is seen from.
      CHECK(distance(made.path.moves[i].to, Vec3{0, 0, 0}) > std::sqrt(3.0) * 50);
      CHECK(dot(made.axes.to[i], made.path.moves[i].to) > 0);
    }
  CHECK(distance(made.axes.to.back(), to_machine.inverse().direction({0, 0, 1})) < 1e-12);
}

TEST_CASE("a path begins where the motion before its first has left the tool", "[unit][gcode]") {
  const MachineSetup machine = turning_trunnion();
  const Program program =
      read_text(kCentred + "G1 X10 Y5 Z3 F500\nX20 A20\nX30 A25 C7\nX35\nX40 A10\n", machine);
  const PathOptions options = turning_options(machine);
  const TurningPath whole = to_turning_path(program, options);
  for (std::size_t first = 1; first < program.motions.size(); ++first) {
    PathOptions from = options;
    from.first = first;
    from.start_mm.reset();
    const TurningPath rest = to_turning_path(program, from);
    const std::size_t skipped = whole.path.moves.size() - rest.path.moves.size();
    CHECK(distance(rest.path.start, whole.path.moves[skipped - 1].to) < kPoseRounding_mm);
    CHECK(distance(rest.axes.start, whole.axes.to[skipped - 1]) < kPoseRounding_mm);
    CHECK(distance(rest.path.moves.back().to, whole.path.moves.back().to) < kPoseRounding_mm);
  }
}

TEST_CASE("turning paths that cannot be made are refused", "[unit][gcode]") {
  const MachineSetup machine = turning_trunnion();
  const Program program = read_text(kCentred + "G1 X10 F500\nX20 A20 C720\n", machine);
  PathOptions options = turning_options(machine, 1e-6);
  options.most_moves = 100;
  CHECK_THROWS_AS(to_turning_path(program, options), ResourceError);
  options = turning_options(machine);
  options.start_mm.reset();
  CHECK_THROWS_AS(to_turning_path(program, options), std::invalid_argument);
  options = turning_options(machine);
  options.reach_mm = std::nan("");
  CHECK_THROWS_AS(to_turning_path(program, options), std::invalid_argument);
  CHECK_THROWS_AS(to_turning_path(program, turning_options(machine, 0)), std::invalid_argument);
}

TEST_CASE("feeds that turn and move the tip cut while they turn", "[unit][gcode]") {
  const auto cuts = [](const std::string& begin, const std::string& text) {
    const MachineSetup machine = turning_trunnion();
    const Program program = read_text(begin + text, machine);
    return cuts_while_turning(program, *machine.kinematics, 0, program.motions.size());
  };
  CHECK_FALSE(cuts(kCentred, "G0 X10 A20\nG1 X20 F100\n"));
  CHECK(cuts(kCentred, "G1 X10 F100\nX20 A20\n"));
  CHECK(cuts(kCentred, "G2 X10 I5 A20 F100\n"));
  // The tip stays where it is.
  CHECK_FALSE(cuts(kCentred, "G1 A20 F100\n"));
  CHECK(cuts(kApproach, "G1 A20 F100\n"));
}

TEST_CASE("how far a tool reaches from its tip", "[unit]") {
  CHECK(reach_mm(parse_cutter("flat:D=6,L=4")) == 5);
  CHECK(reach_mm(parse_cutter("flat:D=6,L=4,shank=6:4,holder=10:4")) == 13);
}

}  // namespace limitgauge::model
