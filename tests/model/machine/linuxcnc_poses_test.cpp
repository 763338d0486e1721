// Machines as LinuxCNC's kinematics modules document them, at poses that are worked out by hand:
// right angles, and 30 degrees, of which the sine is a half. LinuxCNC's places have the tool's
// length added along Z; it is taken off here. tests/agreement/linuxcnc goes through many more poses
// where the modules are installed.

#include <cmath>
#include <vector>

#include "model/machine/kinematics.h"
#include "tests/support/catch.h"

namespace limitgauge::model {
namespace {

struct WorkedPose {
  RotaryAngles angles_deg;
  Vec3 tip_mm;
};

void check_poses(const Kinematics& machine, const Vec3& joints_mm,
                 const std::vector<WorkedPose>& poses) {
  for (const WorkedPose& pose : poses) {
    const Vec3 tip = machine.stand(joints_mm, pose.angles_deg, 50).tip_mm;
    CAPTURE(pose.angles_deg[0], pose.angles_deg[1], pose.angles_deg[2], tip.x, tip.y, tip.z);
    // Rounding of a few hundred millimetres, some hundred times.
    CHECK(distance(tip, pose.tip_mm) < 1e-11);
  }
}

const Vec3 kRotationPoint{10, 20, 30};
const double kCosine = std::sqrt(0.75);  ///< of 30 degrees

}  // namespace

TEST_CASE("poses of xyzac-trt-kins with a y-offset of 4 and a z-offset of 6", "[unit]") {
  const Kinematics machine{
      MachineKind::table_table,
      {{'A', {1, 0, 0}, kRotationPoint + Vec3{0, 4, 6}}, {'C', {0, 0, 1}, kRotationPoint}}};
  // The tip lies by (3, 7, 14) from A. At 90 degrees Y takes the 14 and Z loses the 7; then come
  // the offset of 4, the turn about C, and the rotation point.
  check_poses(machine, {13, 31, 100},
              {{{0, 0, 0}, {13, 31, 50}},
               {{90, 0, 0}, {13, 38, 29}},
               {{90, 0, 90}, {28, 17, 29}},
               {{30, 0, 0}, {13, 31 + 7 * kCosine, 32.5 + 14 * kCosine}}});
}

TEST_CASE("poses of xyzbc-trt-kins with an x-offset of 4 and a z-offset of 6", "[unit]") {
  const Kinematics machine{
      MachineKind::table_table,
      {{'B', {0, 1, 0}, kRotationPoint + Vec3{4, 0, 6}}, {'C', {0, 0, 1}, kRotationPoint}}};
  // By (7, 3, 14) from B: X loses the 14 at 90 degrees, and Z takes the 7.
  check_poses(machine, {21, 23, 100},
              {{{0, 0, 0}, {21, 23, 50}},
               {{0, 90, 0}, {0, 23, 43}},
               {{0, 90, 90}, {13, 30, 43}},
               {{0, 30, 0}, {14 + 7 * kCosine - 7, 23, 36 + 3.5 + 14 * kCosine}}});
}

TEST_CASE("poses of xyzab-tdr-kins with a z-offset of 6", "[unit]") {
  const Kinematics machine{
      MachineKind::table_table,
      {{'B', {0, -1, 0}, kRotationPoint}, {'A', {-1, 0, 0}, kRotationPoint + Vec3{0, 0, 6}}}};
  // By (3, 7, 14) from B, which brings X the 14 and takes 3 from Z at 90 degrees; A, 6 higher,
  // takes what is above it from Y and gives Z the 7.
  check_poses(machine, {13, 27, 94},
              {{{0, 0, 0}, {13, 27, 44}},
               {{90, 0, 0}, {13, 12, 43}},
               {{0, 90, 0}, {24, 27, 27}},
               {{90, 90, 0}, {24, 29, 43}}});
}

TEST_CASE("poses of 5axiskins with a pivot length of 250, 50 of it the tool's", "[unit]") {
  const Kinematics machine{MachineKind::head_head,
                           {{'C', {0, 0, 1}, {0, 0, 200}}, {'B', {0, -1, 0}, {0, 0, 200}}}};
  // The tip goes from 250 below the pivot, which stands at (1, 2, 203), to where B and C point.
  check_poses(machine, {1, 2, 3},
              {{{0, 0, 0}, {1, 2, -47}},
               {{0, 90, 0}, {251, 2, 203}},
               {{0, 90, 90}, {1, 252, 203}},
               {{0, 30, 180}, {1 - 125, 2, 203 - 250 * kCosine}}});
}

}  // namespace limitgauge::model
