#pragma once

#include <vector>

#include "engine/strategy/levels/level_space.h"
#include "engine/strategy/raster/stock_outline.h"

namespace limitgauge::engine::strategy {

/// What the loops of a level are made with; lengths mm.
struct LoopRule {
  model::Box3 stock;
  std::vector<std::uint8_t> stock_pixels;  ///< of the coarse raster: their squares meet the stock
  double cut_radius_mm = 0;                ///< what one pass clears to either side
  double spacing_mm = 0;                   ///< of loops; at most twice the cutting radius
  double border_mm = 0;        ///< distance from the forbidden region at which the last loop runs
  double border_error_mm = 0;  ///< of points left out of it
  double error_mm = 0;         ///< of points left out of the others
};

/// The loops that clear one level, in groups in the order of cutting: by distance from the
/// forbidden region, outermost first, the last along its border. The forbidden region lies on the
/// right of their way. Straight rows where nothing is forbidden.
///
/// Nothing that the tip may reach is left: loops as wide apart as a pass is wide leave places where
/// they turn sharply or end, so what the loops sweep is marked on the raster, each pixel only where
/// all of its square is swept, and loops half way between, as far as something is left near them,
/// then single places, clear the rest.
std::vector<std::vector<Isoline>> level_loops(const LevelSpace& space, const StockOutline& outline,
                                              const LoopRule& rule);

/// Pixels that a level's passes need not clear: no stock is over them, or the tip may not be there.
std::vector<std::uint8_t> spared_pixels(const LevelSpace& space, const LoopRule& rule);

}  // namespace limitgauge::engine::strategy
