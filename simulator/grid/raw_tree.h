#pragma once

#include "model/base/run_control.h"
#include "simulator/grid/vdb_tree.h"
#include "simulator/stock/raw_stock.h"

namespace limitgauge::simulator::vdb {

/// Puts the raw stock's level set within `clip`, whose sides are multiples of a leaf's edge, into
/// an empty tree whose background is the band. The distance to the raw stock is asked for only
/// where cubes that it cannot decide from their middle are left, down to 2³ voxels: it may be
/// costly.
void add_raw(Tree& tree, const RawStock& raw, const Lattice& lattice, const IndexBox& clip,
             const model::RunControl& control);

/// Where a cube is: +1 wholly outside with its band, −1 wholly inside with it, 0 neither.
int raw_side(const RawStock& raw, const Lattice& lattice, double band_mm, const Index3& corner,
             int edge);

}  // namespace limitgauge::simulator::vdb
