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

}  // namespace limitgauge::model
