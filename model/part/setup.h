#pragma once

#include <string>

#include "model/geometry/pose.h"

namespace limitgauge::model {

/// How the part lies in the machine for some of a job's stages: cutters stand along +Z of the
/// setup's frame, which its programs are written in. A job without setups has one without a name,
/// whose frame is the part's.
struct Setup {
  std::string name;
  Pose from_part;  ///< the part's frame to the setup's
};

/// From a cutter's tip to its holder, a unit vector in the part's frame.
inline Vec3 tool_axis(const Setup& setup) {
  return setup.from_part.direction_back({0, 0, 1});
}

}  // namespace limitgauge::model
