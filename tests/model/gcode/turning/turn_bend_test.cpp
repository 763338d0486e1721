#include "model/gcode/turning/turn_bend.h"

#include "tests/model/gcode/turning/turning_poses.h"
#include "tests/support/catch.h"

namespace limitgauge::model {
namespace {

using namespace test;

TurningMotion bending_motion(std::mt19937_64& random, TipControl control) {
  TurningMotion motion;
  motion.frame.control = control;
  motion.frame.tool_length_mm = std::abs(random_place(random, 200).x);
  motion.frame.work_zero_mm = random_place(random, 300);
  if (one_in(random, 3)) motion.frame.length_error_mm = random_place(random, 3).x;
  motion.from_mm = random_place(random, 200);
  motion.to_mm = one_in(random, 4) ? motion.from_mm : motion.from_mm + random_place(random, 50);
  motion.from_deg = random_angles(random, 360);
  const RotaryAngles by = random_angles(random, one_in(random, 3)   ? 2
                                                : one_in(random, 4) ? 400
                                                                    : 40);
  for (std::size_t i = 0; i < 3; ++i)
    motion.to_deg[i] = motion.from_deg[i] + (one_in(random, 4) ? 0 : by[i]);
  return motion;
}

/// The worst that a place of the tool is off, as a share of the bound; of what is well above
/// rounding.
double worst_share(const Kinematics& machine, const TurningMotion& motion, double reach_mm,
                   const TurnPieces& pieces) {
  double from = 0, worst_mm = 0;
  for (const double to : pieces.ends) {
    const StraightMove move(machine, motion, from, to);
    for (int k = 1; k < 8; ++k)
      worst_mm = std::max(worst_mm, move.off_mm(machine, motion, k / 8.0, reach_mm));
    from = to;
  }
  REQUIRE(worst_mm <= pieces.error_mm + kPoseRounding_mm);
  return pieces.error_mm > 1e-6 ? worst_mm / pieces.error_mm : 0;
}

}  // namespace

TEST_CASE("pieces of a turning motion are straight within what is said of them",
          "[property][slow]") {
  std::mt19937_64 random(91);
  const TipControl controls[] = {TipControl::joints, TipControl::tool_centre,
                                 TipControl::dynamic_offset};
  double nearest = 0;
  for (int n = 0; n < 3000; ++n) {
    const Kinematics machine = random_machine(random);
    const TurningMotion motion = bending_motion(random, controls[n % 3]);
    const double limit_mm = std::pow(10, -static_cast<double>(random() % 4));
    const TurnPieces pieces = turn_pieces(machine, motion, 60, limit_mm, 1e6);
    REQUIRE_FALSE(pieces.too_many);
    REQUIRE(pieces.ends.back() == 1);
    REQUIRE(pieces.error_mm <= limit_mm);
    nearest = std::max(nearest, worst_share(machine, motion, 60, pieces));
  }
  // Bounds that nothing comes near would be paid for in moves.
  CHECK(nearest > 0.9);
}

TEST_CASE("what goes straight of itself is one piece", "[unit]") {
  const Kinematics table{MachineKind::table_table, {{'A', {1, 0, 0}, {0, 0, -40}}}};
  TurningMotion motion;
  motion.frame.control = TipControl::tool_centre;
  motion.to_mm = {10, 0, 0}, motion.to_deg = {25, 0, 0};
  // About an axis across it the tool goes along a great circle.
  CHECK(TurnBend(table, motion).place_mm(1, 100) < 1e-12);
  CHECK(turn_pieces(table, motion, 100, 1e-6, 100).ends == std::vector<double>{1});
  // Round the tool's own axis it stands still.
  const Kinematics round{MachineKind::table_table, {{'C', {0, 0, 1}, {0, 0, 0}}}};
  motion.to_deg = {0, 0, 25};
  CHECK(TurnBend(round, motion).place_mm(1, 100) == 0);
}

TEST_CASE("a tip that is carried round bends as a circle does", "[unit]") {
  const Kinematics round{MachineKind::table_table, {{'C', {0, 0, 1}, {0, 0, 0}}}};
  TurningMotion motion;
  motion.from_mm = motion.to_mm = {100, 0, 0};
  motion.to_deg = {0, 0, 1};
  const double turned = std::numbers::pi / 180;
  CHECK(TurnBend(round, motion).tip_mm(1) == Approx(100 * turned * turned / 8));
  CHECK(turn_pieces(round, motion, 0, 0.001, 100).ends.size() == 2);
}

TEST_CASE("pieces beyond what is allowed are said to be too many", "[unit]") {
  const Kinematics round{MachineKind::table_table, {{'C', {0, 0, 1}, {0, 0, 0}}}};
  TurningMotion motion;
  motion.from_mm = motion.to_mm = {100, 0, 0};
  motion.to_deg = {0, 0, 360};
  CHECK(turn_pieces(round, motion, 0, 1e-4, 100).too_many);
  motion.to_deg = {0, 0, 1e9};
  CHECK(turn_pieces(round, motion, 0, 1, 1000).too_many);
  motion.to_deg = {0, 0, 360};
  CHECK(turn_pieces(round, motion, 0, 1e-300, 1e6).too_many);
}

}  // namespace limitgauge::model
