#pragma once

#include <vector>

#include "engine/model/cutter.h"
#include "engine/strategy/height_map.h"

namespace limitgauge::engine::strategy {

/// Cutter and allowance as a stack of discs: no point of the cutter grown by the allowance that
/// lies at least `height_mm` and less than the next disc's above the tip is farther out than
/// `radius_mm`. The last disc has no upper end.
struct Disc {
  double height_mm = 0, radius_mm = 0;
};
/// For flat, ball and bull cutters; `fineness_mm` is the step over the rounding aimed at.
std::vector<Disc> disc_stack(const model::Cutter& cutter, double allowance_mm, double fineness_mm);

/// Where the tip may be at one level.
struct LevelField {
  std::vector<float> clear_mm;  ///< how far the tip's place is from the forbidden region, at least
  bool anything_forbidden = false;
};
/// Signed: negative inside the forbidden region. A lower bound of the true distance, and
/// 1-Lipschitz. Where nothing is forbidden it is the distance from the raster's middle line.
LevelField level_field(const HeightMap& map, const std::vector<Disc>& discs, double tip_z_mm);

/// How many pixels forbid something at `tip_z_mm`, disc by disc: levels with equal counts have
/// equal fields, since the sets are nested. `sorted_z` holds the map's heights in ascending order.
std::vector<std::size_t> level_signature(const std::vector<float>& sorted_z,
                                         const std::vector<Disc>& discs, double tip_z_mm);

}  // namespace limitgauge::engine::strategy
