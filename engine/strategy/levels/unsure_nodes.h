#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "engine/strategy/raster/slope_mask.h"
#include "engine/strategy/raster/tip_raster.h"

namespace limitgauge::engine::strategy {

/// Nodes of a raster whose heights may be wrong, and by how much: which side of a height one of
/// them is on has to be looked up where the two are closer than that.
class UnsureNodes {
 public:
  struct Node {
    double z = 0;
    double error_mm = 0;  ///< of z
    std::size_t at = 0;   ///< in the raster's heights
  };

  /// Those at the lower left of cells of `wanted`.
  UnsureNodes(const TipRaster& tips, const CellMask& wanted);

  /// All that may be on another side of the height, and some more.
  std::span<const Node> near(double height_mm) const;

 private:
  std::vector<Node> nodes_;  ///< ascending z
  double largest_error_mm_ = 0;
};

}  // namespace limitgauge::engine::strategy
