#pragma once

#include <optional>
#include <vector>

#include "model/geometry/pose.h"
#include "model/part/fixture.h"

namespace limitgauge::simulator {

/// A body of the machine that goes with the spindle or with a part of its head: nothing may touch
/// it, in whatever way the tool stands.
struct CarriedBody {
  model::Fixture body;
  /// From the frame that its mesh is in to the path's, the tip being at zero; of turns, whose poses
  /// say it themselves, without meaning.
  model::Pose from_tip;
};

/// What a process is checked against.
struct ProcessLimits {
  /// Contacts shallower than this fail nothing, and are listed as slight_contact; > 0. What is
  /// found does not depend on the stock's voxel.
  double tolerance_mm = 0;
  double near_miss_mm = 0;  ///< passing stock or fixture within this is a near miss; 0: not looked
                            ///< for
  std::optional<model::Box3> travel_mm;  ///< of the tip, infinite where an axis has no limit
  std::vector<model::Fixture> fixtures;
  std::vector<CarriedBody> carried;
};

/// Throws std::invalid_argument unless contacts have a tolerance above 0 and near misses a
/// clearance from 0 up.
void require_contact_limits(const ProcessLimits& limits);

}  // namespace limitgauge::simulator
