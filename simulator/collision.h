#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "simulator/stock_model.h"

namespace limitgauge::simulator {

/// A body of the tool assembly that met material it must not cut.
struct Collision {
  std::size_t move = 0;    ///< index in the path
  std::uint32_t line = 0;  ///< program line
  model::Vec3 point;       ///< deepest place found, mm
  double depth_mm = 0;     ///< a lower bound on how deep the body stands in the material there
  std::string part;        ///< "cutter" (rapid), "shank" or "holder"
};

struct CollisionReport {
  std::vector<Collision> rapid;   ///< rapids whose cutter met standing material
  std::vector<Collision> holder;  ///< any move whose shank or holder met material standing then
};

/// Checks `pass` against the stock as it stands at each move: `before` is the stock at the start of
/// the stage. A contact shallower than `tolerance_mm` is no collision.
CollisionReport find_collisions(const StockModel& before, const Pass& pass, double tolerance_mm,
                                const model::RunControl& control);

}  // namespace limitgauge::simulator
