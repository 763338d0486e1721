#pragma once

#include <vector>

#include "engine/strategy/linking/linking.h"
#include "engine/strategy/locations/limit_locations.h"
#include "engine/strategy/raster/slope_mask.h"
#include "model/base/run_control.h"

namespace limitgauge::engine::strategy {

/// Where contours and where rows cut, over one raster of tip heights.
struct SteepRegions {
  TipRaster tips;
  SlopeCells slopes;
  CellMask steep;           ///< slope at or above the stage's angle
  CellMask contours, rows;  ///< each with its overlap beyond the seam
  CellMask touched;         ///< where tips touch the part but by its edges
  double lowest_mm = 0;     ///< tip height of the lowest contact, but not below the floor
};
SteepRegions find_regions(const surface::PatchModel& model, const LimitLocations& limit,
                          const StageRequest& request, const model::RunControl& control);

/// The passes of a steep-and-shallow stage, in the order of cutting.
struct SteepShallowPasses {
  std::vector<std::vector<CutPass>> levels;  ///< one a contour level, from the top down
  std::vector<CutPass> rows;
  int planes = 0;  ///< levels and rows that have a pass
  std::vector<int> sampling_intervals;
};
/// Contours where the surface is at least `steep_angle_deg` steep, rows where it is flatter (after
/// Lu and Ting). Regions are told apart by the slope of the cutter location surface, which is the
/// surface's slope at the contact; each is cut `overlap_mm` beyond the seam, measured along that
/// surface, and no farther. Levels are so close that contours are nowhere farther apart along the
/// surface than a step (or what the scallop height asks for), rows as in a zigzag.
SteepShallowPasses steep_shallow_passes(const surface::PatchModel& model,
                                        const LimitLocations& limit, const StageRequest& request,
                                        const model::RunControl& control);

}  // namespace limitgauge::engine::strategy
