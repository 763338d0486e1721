#pragma once

#include <vector>

#include "engine/strategy/raster/height_map.h"
#include "model/part/cutter.h"

namespace limitgauge::engine::strategy {

/// Cutter and allowance as a stack of discs: no point of the cutter grown by the allowance that
/// lies at least `height_mm` and less than the next disc's above the tip is farther out than
/// `radius_mm`. The last disc has no upper end: above its flutes a taper is as wide as they are.
struct Disc {
  double height_mm = 0, radius_mm = 0;
};
/// `fineness_mm` is the step over the rounding, and along a cone's radius, aimed at.
std::vector<Disc> disc_stack(const model::Cutter& cutter, double allowance_mm, double fineness_mm);

/// Radius of the fluted part `height_mm` above the tip: what one pass clears of a layer so thick,
/// but for cusps that the next layer's passes take.
double profile_radius_mm(const model::Cutter& cutter, double height_mm);

/// Where the tip may be at one level.
struct LevelField {
  std::vector<float> clear_mm;  ///< how far the tip's place is from the forbidden region, at least
  bool anything_forbidden = false;
};
/// Signed: negative inside the forbidden region. A lower bound of the true distance, and
/// 1-Lipschitz; infinite where nothing is forbidden.
LevelField level_field(const HeightMap& map, const std::vector<Disc>& discs, double tip_z_mm);

/// The same on a part of a map, as far as its border only: values of `near_mm` stand for all
/// greater ones.
struct NearField {
  Raster raster;                ///< a part of the map's
  std::vector<float> clear_mm;  ///< empty where nothing is forbidden in sight
};
/// `within` says where the field is wanted.
NearField near_field(const HeightMap& map, const std::vector<Disc>& discs, double tip_z_mm,
                     const Window& within, double near_mm);

/// How many pixels forbid something, disc by disc, for the tip at each of `tips_z_mm`: levels with
/// equal counts have equal fields, since the sets are nested.
std::vector<std::vector<std::size_t>> level_signatures(const HeightMap& map,
                                                       const std::vector<Disc>& discs,
                                                       const std::vector<double>& tips_z_mm);

}  // namespace limitgauge::engine::strategy
