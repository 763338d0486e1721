#pragma once

#include <array>
#include <vector>

#include "model/geometry/interval.h"
#include "simulator/instrument/dexel_patches.h"
#include "simulator/instrument/dexel_sweep.h"
#include "simulator/tolerance.h"

namespace limitgauge::simulator {

/// Material above the lines of a square part of the grid. Most lines hold a single interval: the
/// highest of each line stands in arrays of its own.
struct DexelTile {
  static constexpr int kEdge = DexelPatches::kLines;
  static constexpr int kLines = kEdge * kEdge;

  DexelTile();
  static int line(int i, int j) { return j * kEdge + i; }
  bool empty(int line) const { return !(bottom[line] < top[line]); }
  /// All intervals of a line, ascending.
  std::vector<model::Interval> material(int line) const;
  void set_material(int line, const std::vector<model::Interval>& intervals);
  double length(int line) const;  ///< of the material on a line, mm
  double highest() const;         ///< minus infinity without material
  std::size_t memory_bytes() const;

  std::array<double, kLines> top, bottom;  ///< of the highest interval
  DexelPatches patches;
  std::vector<std::vector<model::Interval>>
      others;  ///< below it, one a line; empty if none have any
};

/// What one move took from the lines of one tile.
struct TileRemoval {
  double length_mm = 0;   ///< sum over the lines
  double deepest_mm = 0;  ///< most on one line
  /// Places of the lines across and along the move.
  float across_low = 0, across_high = 0, along_low = 0, along_high = 0;
};

/// Takes the sweep from the tile's lines.
TileRemoval cut(DexelTile& tile, const DexelFrame& frame, const DexelSweep& sweep);

}  // namespace limitgauge::simulator
