#pragma once

#include <array>
#include <filesystem>

#include "model/machine/kinematics.h"

namespace limitgauge::linuxcnc {

/// LinuxCNC has places for sixteen joints.
using Joints = std::array<double, 16>;

/// A place as its kinematics have it, all of it in the frame of the workpiece.
struct EmcPose {
  double x, y, z, a, b, c, u, v, w;
};

/// One of LinuxCNC's kinematics modules, loaded. One may be loaded once; it stays.
class KinematicsModule {
 public:
  /// Throws std::runtime_error where it cannot be loaded or does not want to start.
  explicit KinematicsModule(const std::filesystem::path& file);

  /// Switches to the kinematics of this number. Throws std::runtime_error where it has none.
  void switch_to(int type);
  model::Vec3 forward(const Joints& joints) const;
  /// Joints of a pose whose rotary positions are those of `joints`, which the others leave alone.
  Joints inverse(const EmcPose& pose) const;

 private:
  void* library_;
};

}  // namespace limitgauge::linuxcnc
