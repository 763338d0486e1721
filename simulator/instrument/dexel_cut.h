#pragma once

#include <cstddef>
#include <vector>

#include "model/base/run_control.h"
#include "simulator/instrument/dexel_grid.h"
#include "simulator/instrument/dexel_removal.h"

namespace limitgauge::simulator {

/// Bytes of the work in hand while a pass is cut, whatever its length.
inline constexpr std::size_t kDexelWindowBytes = std::size_t{64} << 20;

/// Cuts `tiles` by a pass and returns what each move took. Tiles that no move touches stay shared.
/// The same for any number of threads: each tile sees its moves in order, and what they took is
/// added up in the order of tiles.
std::vector<MoveRemoval> cut_tiles(const DexelLattice& lattice, DexelTiles& tiles, const Pass& pass,
                                   const model::RunControl& control);

}  // namespace limitgauge::simulator
