#pragma once

#include <memory>
#include <vector>

#include "simulator/instrument/dexel_tile.h"
#include "simulator/stock/raw_stock.h"

namespace limitgauge::simulator {

/// Vertical lines in the middle of the equal rectangles into which a stock's box is divided, in
/// square tiles.
struct DexelLattice {
  DexelLattice(const model::Box3& box, double spacing_mm);

  model::Vec3 line_at(int i, int j) const;
  DexelFrame frame(int tile_x, int tile_y) const;
  std::size_t tile(int tile_x, int tile_y) const {
    return static_cast<std::size_t>(tile_y) * static_cast<std::size_t>(tiles_x) +
           static_cast<std::size_t>(tile_x);
  }
  std::size_t tiles() const { return tile(0, tiles_y); }
  double cell_mm2() const { return dx * dy; }

  model::Vec3 corner;
  double dx = 0, dy = 0;
  int nx = 0, ny = 0, tiles_x = 0, tiles_y = 0;
};

using DexelTiles = std::vector<std::shared_ptr<const DexelTile>>;

/// The raw stock on the lines of `lattice`.
DexelTiles raw_tiles(const RawStock& raw, const DexelLattice& lattice);

}  // namespace limitgauge::simulator
