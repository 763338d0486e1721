#include "model/machine/turning_motion.h"

#include "tests/model/machine/kinematics_machines.h"
#include "tests/support/catch.h"

namespace limitgauge::model {
namespace {

using namespace test;

/// Of places within two metres, through some ten turns.
constexpr double kMotionRounding_mm = 1e-9;

MotionFrame random_frame(std::mt19937_64& random, TipControl control) {
  MotionFrame frame;
  frame.control = control;
  frame.tool_length_mm = std::abs(random_place(random, 200).x);
  frame.work_zero_mm = random_place(random, 300);
  frame.plane = turn_about(random_direction(random), random_angles(random, 180)[0]);
  frame.plane.shift_mm = random_place(random, 300);
  return frame;
}

/// Some turn one axis alone, some a little, some through several turns.
TurningMotion random_motion(std::mt19937_64& random, TipControl control) {
  TurningMotion motion{random_frame(random, control), random_place(random, 400), {}, {}, {}};
  motion.to_mm = one_in(random, 4) ? motion.from_mm : random_place(random, 400);
  motion.from_deg = random_angles(random, 360);
  const RotaryAngles by = random_angles(random, one_in(random, 3) ? 2 : 400);
  for (std::size_t i = 0; i < 3; ++i)
    motion.to_deg[i] = motion.from_deg[i] + (one_in(random, 3) ? 0 : by[i]);
  return motion;
}

/// The gauge point goes where the programmed place is at zero; a zero that turned with the tables
/// and axes that did not; or nothing but the plane.
Vec3 tip_by_matrices(const Kinematics& machine, const MotionFrame& frame, const Vec3& programmed,
                     const RotaryAngles& angles_deg) {
  if (frame.control == TipControl::joints)
    return stand_by_matrices(machine, programmed + Vec3{0, 0, frame.tool_length_mm}, angles_deg,
                             frame.tool_length_mm)
        .tip_mm;
  if (frame.control == TipControl::tool_centre) return frame.plane.point(programmed);
  const Matrix back = table_back_and_head(machine, angles_deg).first;
  return frame.work_zero_mm + applied(back, programmed - frame.work_zero_mm, 0);
}

/// How far a rotation is from another: the root of the sum of squares is 2√2 sin(angle / 2).
double turn_between_rad(const Pose& a, const Pose& b) {
  double sum = 0;
  for (int row = 0; row < 3; ++row) sum += length_squared(a.rows[row] - b.rows[row]);
  return 2 * std::asin(std::min(1.0, std::sqrt(sum / 8)));
}

const TipControl kTipControls[] = {TipControl::joints, TipControl::tool_centre,
                                   TipControl::dynamic_offset};

void check_speeds(const Kinematics& machine, const TurningMotion& motion, int steps) {
  const double tip_mm = motion.tip_speed_mm(machine) / steps, turn = motion.turn_rad() / steps;
  Pose before = motion.tool_at(machine, 0);
  for (int k = 1; k <= steps; ++k) {
    const Pose now = motion.tool_at(machine, k / static_cast<double>(steps));
    REQUIRE(distance(now.shift_mm, before.shift_mm) <= tip_mm + kMotionRounding_mm);
    // The root of rounding's square: 1e-15 of entries.
    REQUIRE(turn_between_rad(now, before) <= turn + 1e-12);
    before = now;
  }
}

}  // namespace

TEST_CASE("where a programmed place is in the workpiece under the three controls", "[unit]") {
  const Kinematics machine{MachineKind::table_table, {{'C', {0, 0, 1}, {10, 20, 0}}}};
  MotionFrame frame;
  frame.work_zero_mm = {10, 30, 5};
  frame.plane.shift_mm = {1, 1, 1};
  const RotaryAngles angles{0, 0, 90};
  // From the axis by (3, 0): turned back it is (0, -3).
  CHECK(distance(frame.in_workpiece(machine, angles).point({13, 20, 7}), {10, 17, 7}) < 1e-12);
  frame.control = TipControl::tool_centre;
  CHECK(frame.in_workpiece(machine, angles).point({13, 20, 7}) == Vec3{14, 21, 8});
  // From the zero by (3, -10) along the machine's axes: along the workpiece's by (-10, -3).
  frame.control = TipControl::dynamic_offset;
  CHECK(distance(frame.in_workpiece(machine, angles).point({13, 20, 7}), {0, 27, 7}) < 1e-12);
}

TEST_CASE("joints of a head move the tip as it would go at zero", "[unit]") {
  const Kinematics machine{MachineKind::head_head, {{'B', {0, 1, 0}, {0, 0, 80}}}};
  MotionFrame frame;
  frame.tool_length_mm = 50;
  CHECK(frame.in_workpiece(machine, {}) == Pose{});
  // An arm of 130 from the axis, which is 130 above the place.
  CHECK(distance(frame.in_workpiece(machine, {0, 90, 0}).point({1, 2, 3}), {-129, 2, 133}) < 1e-12);
}

TEST_CASE("a motion's ends and what is between stand where matrices put them", "[property]") {
  std::mt19937_64 random(31);
  for (int n = 0; n < 3000; ++n) {
    const Kinematics machine = random_machine(random);
    const TurningMotion motion = random_motion(random, kTipControls[n % 3]);
    for (const double t : {0.0, 0.3, 1.0}) {
      const RotaryAngles angles = motion.angles_at(t);
      const Pose tool = motion.tool_at(machine, t);
      const Vec3 programmed = motion.from_mm * (1 - t) + motion.to_mm * t;
      const Vec3 tip = tip_by_matrices(machine, motion.frame, programmed, angles);
      REQUIRE(distance(tool.shift_mm, tip) < kMotionRounding_mm);
      REQUIRE(distance(tool.direction({0, 0, 1}), machine.stand({}, angles, 0).axis) < 1e-13);
    }
    REQUIRE(motion.angles_at(0) == motion.from_deg);
    for (int i = 0; i < 3; ++i)
      REQUIRE(std::abs(motion.angles_at(1)[i] - motion.to_deg[i]) < 1e-12);
  }
}

TEST_CASE("neither tip nor tool goes faster than the bounds of its motion", "[property][slow]") {
  std::mt19937_64 random(32);
  for (int n = 0; n < 3000; ++n) {
    const Kinematics machine = random_machine(random);
    check_speeds(machine, random_motion(random, kTipControls[n % 3]), 40);
  }
}

TEST_CASE("about one axis the bounds are reached", "[unit]") {
  TurningMotion motion{{}, {13, 20, 0}, {13, 20, 0}, {}, {0, 0, 180}};
  const double half_turn = std::numbers::pi;
  CHECK(motion.turn_rad() == Approx(half_turn).epsilon(1e-15));
  const Kinematics table{MachineKind::table_table, {{'C', {0, 0, 1}, {10, 20, 0}}}};
  CHECK(motion.tip_speed_mm(table) == Approx(3 * half_turn).epsilon(1e-14));
  motion.frame.control = TipControl::dynamic_offset;
  motion.frame.work_zero_mm = {13, 15, 0};
  CHECK(motion.tip_speed_mm(table) == Approx(5 * half_turn).epsilon(1e-14));
  motion.frame.control = TipControl::tool_centre;
  CHECK(motion.tip_speed_mm(table) == 0);
  motion.frame = {TipControl::joints, 50, {}, {}};
  motion.to_deg = {0, 180, 0};
  const Kinematics head{MachineKind::head_head, {{'B', {0, 1, 0}, {0, 0, 80}}}};
  CHECK(motion.tip_speed_mm(head) == Approx(130 * half_turn).epsilon(1e-14));
}

TEST_CASE("axes that the machine or the motion leaves alone cost nothing", "[unit]") {
  const Kinematics machine{MachineKind::head_table,
                           {{'B', {0, 1, 0}, {0, 0, 80}}, {'C', {0, 0, 1}, {10, 20, 0}}}};
  TurningMotion motion{{TipControl::joints, 50, {}, {}}, {13, 20, 0}, {13, 24, 0}, {}, {}};
  CHECK(motion.tip_speed_mm(machine) == Approx(4).epsilon(1e-15));
  motion.to_deg = {90, 0, 0};  // no such axis: a reader lets none through
  CHECK(motion.tip_speed_mm(machine) == Approx(4).epsilon(1e-15));
}

}  // namespace limitgauge::model
