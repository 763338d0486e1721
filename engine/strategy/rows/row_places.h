#pragma once

#include <vector>

#include "engine/strategy/locations/limit_locations.h"
#include "engine/strategy/rows/drive_rows.h"
#include "model/base/run_control.h"

namespace limitgauge::engine::strategy {

/// Where the drive planes of a stage stand and how far rows reach in them, mm. `across` counts to
/// the left of the rows' direction, `along` in it.
struct RowPlaces {
  DriveFrame frame;
  double along_low = 0, along_high = 0;
  std::vector<double> across;  ///< ascending

  Vec3 at(double along, double across_mm) const { return frame.to_part({along, across_mm, 0}); }
};

/// Distance of two tips whose cusp over a plane is as high as the scallop asked for; the step where
/// none is asked for or it is closer. Throws std::invalid_argument for a cutter without a corner
/// radius: it leaves steps, not cusps.
double tip_distance_mm(const StageRequest& request);

/// Planes over the part grown by the cutter's radius and what it keeps away: as the paper counts
/// them; closer together where a scallop height asks for it.
RowPlaces place_rows(const LimitLocations& limit, const StageRequest& request,
                     const model::RunControl& control);

}  // namespace limitgauge::engine::strategy
