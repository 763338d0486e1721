#pragma once

#include <cstddef>
#include <vector>

#include "simulator/stock/memory_forecast.h"

namespace limitgauge::simulator {

/// How a stock's level set is held within a memory limit: whole, or in tiles that are built one
/// after the other, beside a coarser whole one for pictures.
struct StockLayout {
  bool whole = true;
  GridForecast forecast;        ///< of the whole grid
  std::vector<IndexBox> tiles;  ///< runs of columns of blocks, x before y; none where whole
  int coarsening = 1;           ///< the coarser grid's voxel over this one's
  double bytes = 0;             ///< at most held at a time, the passes' moves included
};

/// The layout of `material` on `lattice`. Half of what the moves leave of the limit is for a tile,
/// a quarter for the coarser grid. Throws ResourceError where a single column of blocks or the
/// moves alone do not fit, naming a voxel that would do where there is one.
StockLayout choose_layout(const Material& material, const Lattice& lattice, std::size_t limit_bytes,
                          const model::RunControl& control);

}  // namespace limitgauge::simulator
