// kinematics_modules [FOLDER]: whether model::Kinematics puts the tool where LinuxCNC's own
// kinematics modules put it. Prints the worst difference of each; exits 0 where all agree, 1 on a
// difference, 77 where the modules are not installed.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <limits>
#include <random>
#include <string>

#include "tests/agreement/linuxcnc/kinematics_module.h"
#include "tests/agreement/linuxcnc/known_modules.h"

namespace limitgauge::linuxcnc {
namespace {

using model::RotaryAngles;
using model::Vec3;

constexpr int kPositions = 100000, kPositionsOfMachine = 20;
/// Within two metres both sides round some ten times by 2e-13 mm. Measured against LinuxCNC 2.9: at
/// most 3.1e-12 mm for tips, 3e-12 mm for joints and 7.4e-15 for axes.
constexpr double kTolerance_mm = 1e-9;
/// Of a direction that is the difference of two places this far from each other.
constexpr double kApart_mm = 100, kTolerance = 1e-11;

struct Worst {
  double tip_mm = 0, axis = 0, inverse_mm = 0;

  bool agrees() const {
    return tip_mm <= kTolerance_mm && inverse_mm <= kTolerance_mm && axis <= kTolerance;
  }
};

/// What is no number is worst, and stays so.
void take(double& worst, double difference) {
  worst = std::isnan(difference) ? std::numeric_limits<double>::infinity()
                                 : std::max(worst, difference);
}

/// The joint of W, which draws the tool back along itself, or that of Z, where the tool is upright.
std::size_t joint_along_tool(const KnownModule& known) {
  const std::size_t w = std::string(known.words).find('W');
  return w == std::string::npos ? 2 : 3 + w;
}

/// From the tip to the spindle: where the module puts what is kApart_mm further back.
Vec3 axis_by_module(const KinematicsModule& module, const KnownModule& known, Joints joints) {
  const Vec3 here = module.forward(joints);
  const std::size_t along = joint_along_tool(known);
  joints[along] += kApart_mm;
  const Vec3 way = (module.forward(joints) - here) / kApart_mm;
  return along == 2 ? way : -way;
}

RotaryAngles angles_of(const KnownModule& known, const Joints& joints) {
  RotaryAngles angles{};
  for (int k = 0; k < 2; ++k) angles[known.words[k] - 'A'] = joints[3 + k];
  return angles;
}

/// LinuxCNC's places are the tip's with the tool's length added along Z, however the tool leans:
/// its interpreter takes it off again.
void compare(const KinematicsModule& module, const KnownModule& known, const Case& drawn,
             const Joints& joints, Worst& worst) {
  const Vec3 gauge{joints[0], joints[1], joints[2]}, length{0, 0, drawn.tool_length_mm};
  const RotaryAngles angles = angles_of(known, joints);
  const model::ToolStand stand = drawn.machine.stand(gauge, angles, drawn.tool_length_mm);
  const Vec3 programmed = stand.tip_mm + length;
  take(worst.tip_mm, distance(module.forward(joints), programmed));
  take(worst.axis, distance(axis_by_module(module, known, joints), stand.axis));
  const Joints back = module.inverse(
      {programmed.x, programmed.y, programmed.z, angles[0], angles[1], angles[2], 0, 0, 0});
  take(worst.inverse_mm, distance({back[0], back[1], back[2]}, gauge));
}

Joints drawn_joints(std::mt19937_64& random) {
  std::uniform_real_distribution<> place(-1000, 1000), angle(-720, 720);
  Joints joints{place(random), place(random), place(random), angle(random), angle(random)};
  return joints;
}

Worst worst_of(KinematicsModule& module, const KnownModule& known) {
  std::mt19937_64 random(41);
  Worst worst;
  for (int n = 0; n < kPositions / kPositionsOfMachine; ++n) {
    const Case drawn = known.draw(random);
    for (int k = 0; k < kPositionsOfMachine; ++k)
      compare(module, known, drawn, drawn_joints(random), worst);
  }
  return worst;
}

int run(const std::filesystem::path& folder) {
  bool agree = true;
  for (const KnownModule& known : known_modules()) {
    const auto file = folder / (std::string(known.name) + ".so");
    if (!std::filesystem::exists(file)) {
      std::printf("skipped: %s is not there (Debian: linuxcnc-uspace)\n", file.c_str());
      return 77;
    }
    KinematicsModule module(file);
    module.switch_to(known.type);
    const Worst worst = worst_of(module, known);
    std::printf("%s: %d positions, tip %.2g mm, axis %.2g, joints %.2g mm\n", known.name,
                kPositions, worst.tip_mm, worst.axis, worst.inverse_mm);
    agree = agree && worst.agrees();
  }
  return agree ? 0 : 1;
}

}  // namespace
}  // namespace limitgauge::linuxcnc

int main(int count, char** arguments) {
  try {
    return limitgauge::linuxcnc::run(count > 1 ? arguments[1] : "/usr/lib/linuxcnc/modules");
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
