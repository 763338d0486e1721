#pragma once

#include <optional>

#include "model/geometry/vec3.h"

namespace limitgauge::reports::record {

/// What a process was checked by, as the job states it or as it is where nothing is stated.
struct ProcessLimits {
  double contact_tolerance_mm = 0;  ///< collisions shallower than this fail nothing
  double near_miss_mm = 0;          ///< what passes within this is a near miss; 0: not looked for
  std::optional<model::Box3> travel_mm;  ///< of the tip; infinite where an axis has no limit
};

}  // namespace limitgauge::reports::record
