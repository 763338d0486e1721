#pragma once

#include <cstdint>
#include <vector>

#include "engine/strategy/raster/tip_raster.h"

namespace limitgauge::engine::strategy {

/// A flag for every cell between four nodes of a raster, row by row.
struct CellMask {
  Raster nodes;
  std::vector<std::uint8_t> set;

  CellMask() = default;
  explicit CellMask(const Raster& raster)
      : nodes(raster),
        set(static_cast<std::size_t>(raster.columns - 1) *
            static_cast<std::size_t>(raster.rows - 1)) {}
  int columns() const { return nodes.columns - 1; }
  int rows() const { return nodes.rows - 1; }
  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * columns() + column;
  }
  /// Whether the cell under (x, y) is set; outside the raster nothing is.
  bool at(double x, double y) const;
};
CellMask both(CellMask a, const CellMask& b);

/// What one cell of the cutter location surface is like. The slope of that surface is the slope of
/// the limit surface where the cutter touches it.
struct SlopeCell {
  double low_mm = 0, high_mm = 0;  ///< of the tip; down to the lowest height beside nothing
  double slope_rad = 0;            ///< from the horizontal; upright where the surface ends
  bool covered = false;            ///< something is under the cutter at a node of it
};
struct SlopeCells {
  Raster nodes;
  std::vector<SlopeCell> cells;
};
/// `lowest_mm`: how far walls go down where nothing is beside them.
SlopeCells measure_slopes(const TipRaster& tips, double lowest_mm);

/// Covered cells at least, respectively less, steep than `angle_rad`.
CellMask steep_cells(const SlopeCells& slopes, double angle_rad);
CellMask shallow_cells(const SlopeCells& slopes, double angle_rad);

/// `mask` and the cells that are no farther than `distance_mm` along the cutter location surface:
/// up and down a wall counts, so that what is grown does not reach from its head to its foot.
CellMask grown(const CellMask& mask, const SlopeCells& slopes, double distance_mm);

}  // namespace limitgauge::engine::strategy
