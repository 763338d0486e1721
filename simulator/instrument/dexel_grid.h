#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "model/base/run_control.h"
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

/// The raw stock on one line.
std::vector<model::Interval> raw_on_line(const RawStock& raw, double x, double y);
/// The raw stock on the lines of `lattice`.
DexelTiles raw_tiles(const RawStock& raw, const DexelLattice& lattice);
/// What `standing` says of the line at (x, y); asked from several threads at once.
using LineMaterial = std::function<std::vector<model::Interval>(double x, double y)>;
DexelTiles tiles_of(const LineMaterial& standing, const DexelLattice& lattice,
                    const model::RunControl& control);

}  // namespace limitgauge::simulator
