#include "model/machine/kinematics.h"

#include "tests/model/machine/kinematics_machines.h"
#include "tests/support/catch.h"

namespace limitgauge::model {
namespace {

using namespace test;

/// On places within a metre, through two turns: some 1e-12 mm of rounding, and a hundred times
/// that.
constexpr double kRounding_mm = 1e-10;
constexpr double kRounding = 1e-13;  ///< of directions

void check_stand(const Kinematics& machine, const Vec3& gauge_mm, const RotaryAngles& angles_deg,
                 double tool_length_mm, const ToolStand& expected) {
  const ToolStand stand = machine.stand(gauge_mm, angles_deg, tool_length_mm);
  CAPTURE(stand.tip_mm.x, stand.tip_mm.y, stand.tip_mm.z);
  CAPTURE(stand.axis.x, stand.axis.y, stand.axis.z);
  CHECK(distance(stand.tip_mm, expected.tip_mm) < kRounding_mm);
  CHECK(distance(stand.axis, expected.axis) < kRounding);
}

const RotaryAxis kA{'A', {1, 0, 0}, {0, 20, 30}};
const RotaryAxis kB{'B', {0, 1, 0}, {10, 0, 30}};
const RotaryAxis kC{'C', {0, 0, 1}, {10, 20, 0}};

}  // namespace

TEST_CASE("one table turns the tool the other way round its axis", "[unit]") {
  const Kinematics tilting{MachineKind::table_table, {kA}};
  // The tip lies at (5, 20 + 7, 30 - 4); turned back by a quarter, Y becomes -Z and Z becomes Y.
  check_stand(tilting, {5, 27, 76}, {90, 0, 0}, 50, {{5, 16, 23}, {0, 1, 0}});
  const Kinematics round{MachineKind::table_table, {kC}};
  check_stand(round, {13, 20, 60}, {0, 0, 90}, 50, {{10, 17, 10}, {0, 0, 1}});
  check_stand(round, {13, 20, 60}, {0, 0, -90}, 50, {{10, 23, 10}, {0, 0, 1}});
}

TEST_CASE("one head swings the tool round its axis", "[unit]") {
  // The axis runs 80 above the gauge point, the tip is 50 below: an arm of 130.
  const Kinematics head{MachineKind::head_head, {{'B', {0, 1, 0}, {0, 0, 80}}}};
  check_stand(head, {1, 2, 3}, {0, 90, 0}, 50, {{1 - 130, 2, 3 + 80}, {1, 0, 0}});
  const double c = std::sqrt(0.75);
  check_stand(head, {1, 2, 3}, {0, 30, 0}, 50, {{1 - 130 * 0.5, 2, 3 + 80 - 130 * c}, {0.5, 0, c}});
}

TEST_CASE("of two tables the first carries the other", "[unit]") {
  const Kinematics machine{MachineKind::table_table, {kA, kC}};
  // Back about A first: (13, 27, 26) becomes (13, 16, 23); then about C, by (3, -4) from its axis.
  check_stand(machine, {13, 27, 76}, {90, 0, 90}, 50, {{6, 17, 23}, {1, 0, 0}});
  const Kinematics other{MachineKind::table_table, {kB, kC}};
  // (13, 27, 26), seen from B by (3, -4) in X and Z, becomes (10 + 4, 27, 30 + 3), then (17, 16).
  check_stand(other, {13, 27, 76}, {0, 90, 90}, 50, {{17, 16, 33}, {0, 1, 0}});
}

TEST_CASE("a head comes before a table", "[unit]") {
  const Kinematics machine{MachineKind::head_table, {{'B', {0, 1, 0}, {0, 0, 80}}, kC}};
  // The tip at (1 - 130, 2, 83), seen from C by (-139, -18).
  check_stand(machine, {1, 2, 3}, {0, 90, 90}, 50, {{10 - 18, 20 + 139, 83}, {0, -1, 0}});
}

TEST_CASE("of two heads the first carries the other", "[unit]") {
  const Kinematics machine{MachineKind::head_head,
                           {{'C', {0, 0, 1}, {5, 0, 0}}, {'B', {0, 1, 0}, {0, 0, 80}}}};
  // B brings the tip to (-130, 0, 80) from the gauge point, C turns (-135, 0) about (5, 0).
  check_stand(machine, {1, 2, 3}, {0, 90, 90}, 50, {{6, -133, 83}, {0, 1, 0}});
}

TEST_CASE("where all axes are at zero, the tool stands under the gauge point", "[unit]") {
  std::mt19937_64 random(11);
  for (int n = 0; n < 100; ++n)
    check_stand(random_machine(random), {1, 2, 3}, {}, 50, {{1, 2, -47}, {0, 0, 1}});
}

TEST_CASE("a tool stands where matrices of 4 by 4 put it, and upright in its own frame",
          "[property]") {
  std::mt19937_64 random(12);
  for (int n = 0; n < 5000; ++n) {
    const Kinematics machine = random_machine(random);
    const Vec3 gauge = random_place(random, 500);
    const RotaryAngles angles = random_angles(random, 720);
    const double length_mm = random_place(random, 200).x;
    const ToolStand stand = machine.stand(gauge, angles, length_mm);
    const ToolStand expected = stand_by_matrices(machine, gauge, angles, length_mm);
    REQUIRE(distance(stand.tip_mm, expected.tip_mm) < kRounding_mm);
    REQUIRE(distance(stand.axis, expected.axis) < kRounding);
    REQUIRE(std::abs(length(stand.axis) - 1) < kRounding);
    REQUIRE(distance(machine.upright(angles).direction(expected.axis), {0, 0, 1}) < kRounding);
    if (machine.kind == MachineKind::table_table)
      REQUIRE(distance(machine.upright(angles).point(stand.tip_mm),
                       gauge + Vec3{0, 0, -length_mm}) < kRounding_mm);
  }
}

TEST_CASE("what is mounted goes with the tables below it", "[unit]") {
  const Kinematics machine{MachineKind::table_table, {kA, kC}};
  const RotaryAngles angles{90, 0, 90};
  CHECK(machine.carried_by(std::nullopt, angles) == Pose{});
  // (13, 27, 26) about A becomes (13, 24, 37); what C carries it turns first, to (3, 23, 26).
  CHECK(distance(machine.carried_by('A', angles).point({13, 27, 26}), {13, 24, 37}) < kRounding_mm);
  CHECK(distance(machine.carried_by('C', angles).point({13, 27, 26}), {3, 24, 33}) < kRounding_mm);
  CHECK(machine.carried_by('C', angles) == machine.table(angles));
  const Kinematics head{MachineKind::head_table, {{'B', {0, 1, 0}, {0, 0, 80}}, kC}};
  CHECK(head.carried_by('C', {0, 30, 40}) == head.table({0, 0, 40}));
}

TEST_CASE("axes are found by their words", "[unit]") {
  const Kinematics machine{MachineKind::head_table, {kB, kC}};
  REQUIRE(machine.axis('C') != nullptr);
  CHECK(machine.axis('C')->point_mm == kC.point_mm);
  CHECK(machine.axis('A') == nullptr);
  CHECK(machine.is_head(0));
  CHECK_FALSE(machine.is_head(1));
  CHECK(std::string(name(machine.kind)) == "head-table");
  CHECK(std::string(name(MachineKind::table_table)) == "table-table");
  CHECK(std::string(name(MachineKind::head_head)) == "head-head");
}

}  // namespace limitgauge::model
