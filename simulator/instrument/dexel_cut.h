#pragma once

#include <vector>

#include "model/base/run_control.h"
#include "simulator/instrument/dexel_grid.h"
#include "simulator/instrument/dexel_removal.h"

namespace limitgauge::simulator {

/// Cuts `tiles` by a pass and returns what each move took. Tiles that no move touches stay shared.
/// The same for any number of threads: each tile sees its moves in order, and what they took is
/// added up in the order of tiles.
std::vector<MoveRemoval> cut_tiles(const DexelLattice& lattice, DexelTiles& tiles, const Pass& pass,
                                   const model::RunControl& control);

}  // namespace limitgauge::simulator
