#pragma once

#include <functional>
#include <vector>

#include "simulator/grid/stock_grid.h"
#include "simulator/stock/column_tops.h"
#include "simulator/stock/material.h"

namespace limitgauge::simulator {

/// A stock whose level set is never held whole: each tile is built from the exact material when it
/// is needed and dropped after. What it gives equals, to the last bit, what a whole grid gives.
class TiledStock {
 public:
  /// Goes over all tiles once, for the volume and the tops.
  TiledStock(const Material& material, const Lattice& lattice, std::vector<IndexBox> tiles,
             const model::RunControl& control);

  using Visit = std::function<void(const StockGrid& tile, const model::RunControl& control)>;
  /// Builds the tiles in order, those alone that meet `region`.
  void each_tile(const Material& material, const model::Box3& region,
                 const model::RunControl& control, const Visit& visit) const;

  const Lattice& lattice() const { return lattice_; }
  const GridVolume& volume() const { return volume_; }
  const ColumnTops& column_tops() const { return tops_; }
  std::size_t size() const { return tiles_.size(); }

 private:
  Lattice lattice_;
  std::vector<IndexBox> tiles_;
  GridVolume volume_;
  ColumnTops tops_;
};

/// The level set that the grid on `lattice` has at `p_mm`, worked out from the exact material; the
/// same but for the last bits of single precision.
double interpolated_value(const Material& material, const Lattice& lattice,
                          const model::Vec3& p_mm);

/// A grid of the whole of `material`.
StockGrid build_grid(const Material& material, const Lattice& lattice, const IndexBox& box,
                     const model::RunControl& control);

/// A control whose progress runs from `from` to `to` of the one it is made from.
model::RunControl part_of(const model::RunControl& control, double from, double to);

}  // namespace limitgauge::simulator
