#include "model/gcode/turning/axis_travel.h"

#include <algorithm>
#include <limits>
#include <random>

#include "model/base/angle.h"
#include "model/base/tolerance.h"
#include "model/gcode/program_path.h"
#include "tests/model/gcode/read_text.h"
#include "tests/model/gcode/turning/turning_machines.h"
#include "tests/support/catch.h"

namespace limitgauge::model {
namespace {

using namespace test;

using Catch::Matchers::WithinAbs;
constexpr double kFree = std::numeric_limits<double>::infinity();
constexpr double kLength_mm = 80;  ///< of the machines' tool

/// A head of one axis, 120 above the gauge point: with the tool an arm of 200.
MachineSetup swinging_head() {
  MachineSetup machine = turning_heads();
  machine.kinematics = Kinematics{MachineKind::head_head, {{'B', {0, 1, 0}, {0, 0, 120}}}};
  return machine;
}

Box3 free_box() {
  return {{-kFree, -kFree, -kFree}, {kFree, kFree, kFree}};
}

std::vector<TravelBreach> breaches_of(const Program& program, const MachineSetup& machine,
                                      const Box3& limits) {
  return beyond_travel(program, {*machine.kinematics, limits, {}, {10, 20, 170}, kLength_mm}, 0,
                       program.motions.size());
}

}  // namespace

TEST_CASE("a head that leans about the tip takes X and Z round it", "[unit]") {
  const MachineSetup machine = swinging_head();
  // The tip stands at (10, 20, 70); X and Z go to 10 + 200 sin B and 70 - 200 (1 - cos B).
  const Program program = read_text(kCentred + "G0 B30\nG0 B90\nG0 B-60\n", machine);
  REQUIRE(program.motions.size() == 4);
  Box3 limits = free_box();
  limits.high.x = 120;
  const auto over = breaches_of(program, machine, limits);
  REQUIRE(over.size() == 2);  // The way back begins where it is beyond.
  CHECK(over[0].line == 5);
  CHECK(over[0].axis == 0);
  CHECK(over[0].above);
  CHECK_THAT(over[0].depth_mm, WithinAbs(90, 1e-9));
  CHECK(over[1].line == 6);
  // A tenth less than the most may be named of what lies between ends.
  CHECK(over[1].depth_mm > 90 / 1.1 - 0.1);
  CHECK(over[1].depth_mm < 90 + 1e-9);
  limits.high.x = 211;
  limits.low.z = -30 - 100 - 0.5;
  CHECK(breaches_of(program, machine, limits).empty());
}

TEST_CASE("what lies between two ends within the travel is seen", "[unit]") {
  const MachineSetup machine = swinging_head();
  const Program program = read_text(kCentred + "G0 B-60\nG0 B60\n", machine);
  Box3 limits = free_box();
  limits.high.z = 70 - 50;  // Reached at B41.4 on both sides; upright it is at 70.
  const auto over = breaches_of(program, machine, limits);
  REQUIRE(over.size() == 3);
  CHECK(over[2].line == 5);
  CHECK(over[2].axis == 2);
  CHECK_THAT(over[2].depth_mm, WithinAbs(50, 1e-9));
}

TEST_CASE("places that are joints are X, Y and Z themselves, their ways straight", "[unit]") {
  const MachineSetup machine = swinging_head();
  const Program program = read_text(kApproach + "G1 X40 B90 F500\nG1 X50 Z-20\n", machine);
  Box3 limits = free_box();
  limits.high.x = 50;  // X40 is at 50.
  CHECK(breaches_of(program, machine, limits).size() == 1);
  limits.high.x = 60;
  limits.low.z = -50;
  CHECK(breaches_of(program, machine, limits).empty());
  limits.low.z = -49.5;
  const auto over = breaches_of(program, machine, limits);
  REQUIRE(over.size() == 1);
  CHECK(over[0].line == 4);
  CHECK_FALSE(over[0].above);
  CHECK_THAT(over[0].depth_mm, WithinAbs(0.5, 1e-9));
}

TEST_CASE("a full circle goes beyond between its ends", "[unit]") {
  const MachineSetup machine = swinging_head();
  const Program program = read_text(kCentred + "G0 B20\nG1 X0 Y0 Z50 F500\nG2 I20 J0\n", machine);
  Box3 limits = free_box();
  // At the start of the circle X stands at 10 + 200 sin 20; on its other side 40 further.
  limits.high.x = 10 + 200 * std::sin(radians(20.0)) + 30;
  const auto over = breaches_of(program, machine, limits);
  REQUIRE(over.size() == 1);
  CHECK(over[0].line == 6);
  CHECK_THAT(over[0].depth_mm, WithinAbs(10, 2 * kTravelLook_mm));
}

TEST_CASE("heights that nothing states are not held against the travel", "[unit]") {
  MachineSetup machine = turning_trunnion();
  const Program program = read_text("G21 G90\nG28 G91 Z0\nG90 G0 X0 Y0\n" + kApproach, machine);
  const auto parked =
      std::ranges::count_if(program.motions, [](const Motion& motion) { return motion.parked; });
  Box3 limits = free_box();
  limits.low.z = 1e4, limits.high.z = 2e4;
  CHECK(parked > 0);
  CHECK(static_cast<std::ptrdiff_t>(breaches_of(program, machine, limits).size()) ==
        static_cast<std::ptrdiff_t>(program.motions.size()) - parked);
}

namespace {

/// X, Y and Z of motion `i` at a share `t` of it: the gauge point, found as that which puts the tip
/// of a tool where the motion has it (Kinematics::stand), less the tool's length.
class Shown {
 public:
  Shown(const Program& program, const Kinematics& machine) : program_(program), machine_(machine) {}

  /// By how much it is out of `limits` at most, of many places; of a motion that does not bend at
  /// its end: where it begins is the one's before.
  double most_mm(std::size_t motion, const Box3& limits) const {
    constexpr int kPlaces = 400;
    const bool bends =
        program_.motions[motion].kind == MotionKind::arc ||
        std::ranges::find(program_.turns, motion, &AxisTurn::motion) != program_.turns.end();
    double most = -kFree;
    for (int k = bends ? 1 : kPlaces; k <= kPlaces; ++k) {
      const Vec3 at = place(motion, static_cast<double>(k) / kPlaces);
      for (int axis = 0; axis < 3; ++axis)
        most = std::max({most, limits.low[axis] - at[axis], at[axis] - limits.high[axis]});
    }
    return most;
  }

 private:
  Vec3 place(std::size_t i, double t) const {
    const Motion& motion = program_.motions[i];
    const auto turn = std::ranges::find(program_.turns, i, &AxisTurn::motion);
    const bool arc = motion.kind == MotionKind::arc;
    if (turn == program_.turns.end()) {
      RotaryAngles angles_deg{};
      MotionFrame frame;
      std::size_t since = 0;
      for (const FrameChange& change : program_.frames)
        if (change.motion <= i)
          frame = change.frame, angles_deg = change.angles_deg, since = change.motion;
      for (const AxisTurn& turned : program_.turns)
        if (turned.motion < i && turned.motion >= since)
          frame = turned.turn.frame, angles_deg = turned.turn.to_deg;
      const auto before = std::ranges::find(program_.turns, i - 1, &AxisTurn::motion);
      const Vec3 from =
          before == program_.turns.end() ? program_.motions[i - 1].to : before->turn.to_mm;
      const Vec3 named = arc ? arc_of(motion, from).point_at(t) : from + (motion.to - from) * t;
      return axes_at(frame.in_workpiece(machine_, angles_deg).point(named), angles_deg);
    }
    TurningMotion at = turn->turn;
    if (arc) at.from_mm = at.to_mm = arc_of(motion, turn->turn.from_mm).point_at(t);
    return axes_at(at.tool_at(machine_, t).shift_mm, at.angles_at(t));
  }
  Vec3 axes_at(const Vec3& tip_mm, const RotaryAngles& angles_deg) const {
    // stand() is affine in the gauge point and turns it: its inverse by what it does to zero and to
    // the axes.
    const Vec3 zero = machine_.stand({}, angles_deg, kLength_mm).tip_mm;
    Vec3 gauge;
    for (int axis = 0; axis < 3; ++axis) {
      Vec3 unit;
      unit[axis] = 1;
      gauge[axis] = dot(tip_mm - zero, machine_.stand(unit, angles_deg, kLength_mm).tip_mm - zero);
    }
    return gauge - Vec3{0, 0, kLength_mm};
  }

  const Program& program_;
  const Kinematics& machine_;
};

class RandomProgram {
 public:
  explicit RandomProgram(std::mt19937& random) : random_(random) {}

  std::string text(const Kinematics& machine) {
    std::string text = kCentred + "G1 X1 Y1 Z50 F900\n";
    for (int line = 0; line < 12; ++line) {
      const bool arc = within(0, 1) < 0.3;
      text += arc ? "G3 X" + number(-20, 20) + " Y" + number(-20, 20) + " R90"
                  : "G1 X" + number(-80, 80) + " Y" + number(-80, 80) + " Z" + number(0, 90);
      if (within(0, 1) < 0.6)
        for (const RotaryAxis& axis : machine.axes) text += axis.word + number(-100, 100);
      text += "\n";
    }
    return text;
  }
  double within(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }

 private:
  std::string number(int low, int high) {
    return std::to_string(std::uniform_int_distribution<int>(low, high)(random_));
  }
  std::mt19937& random_;
};

/// Between ends the search leaves out a hundredth of a millimetre and a tenth; the places held
/// against it are 400 of a motion, of which none is farther from the next than 2 mm or so.
void check_against_places(const Program& program, const MachineSetup& machine, const Box3& limits) {
  const auto over = breaches_of(program, machine, limits);
  const Shown shown(program, *machine.kinematics);
  for (std::size_t i = 3; i < program.motions.size(); ++i) {
    const auto found = std::ranges::find(over, i, &TravelBreach::motion);
    const double most = shown.most_mm(i, limits);
    CAPTURE(i, program.motions[i].line, most);
    if (found == over.end()) {
      CHECK(most <= kTravelLook_mm + 1e-6);
      continue;
    }
    CHECK(found->depth_mm > 0);
    CHECK(found->depth_mm >= most / 1.1 - 3 * kTravelLook_mm);
    // It is a place of the motion: no farther out than the places beside it are, by their spacing.
    CHECK(found->depth_mm <= most + 2.5);
  }
}

}  // namespace

TEST_CASE("random programs go beyond where many places of them do", "[property]") {
  const MachineSetup machine = GENERATE(turning_trunnion(), turning_heads(), turning_head_table());
  std::mt19937 random(7);
  RandomProgram maker(random);
  for (int round = 0; round < 30; ++round) {
    const std::string text = maker.text(*machine.kinematics);
    CAPTURE(text);
    Box3 limits;
    for (int axis = 0; axis < 3; ++axis) {
      limits.low[axis] = maker.within(-400, 0);
      limits.high[axis] = maker.within(50, 400);
    }
    check_against_places(read_text(text, machine), machine, limits);
  }
}

}  // namespace limitgauge::model
