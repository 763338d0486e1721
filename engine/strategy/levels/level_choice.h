#pragma once

#include <vector>

#include "engine/strategy/raster/slope_mask.h"

namespace limitgauge::engine::strategy {

struct LevelRule {
  double distance_mm = 0;  ///< largest distance of neighbouring levels along the surface
  double lowest_mm = 0;    ///< the last level, where anything is to be cut so low
};

/// Heights of contour levels over the cells of `cut`, from the top down. The way down to the next
/// level is the distance asked for times the sine of the least slope of any `steep` cell that lies
/// between: along the surface levels are nowhere farther apart. Level places beside steep ones get
/// a level of their own, so that a wall is cut down to its foot; so does the lowest place.
std::vector<double> choose_levels(const SlopeCells& slopes, const CellMask& cut,
                                  const CellMask& steep, const LevelRule& rule);

}  // namespace limitgauge::engine::strategy
