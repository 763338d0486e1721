#pragma once

#include "model/base/run_control.h"
#include "simulator/instrument/dexel_stock.h"

namespace limitgauge::simulator {

/// What each move of a pass that turns its tool as it goes took away: of what stands on the lines
/// of `before` and not on those of `after` (dexels_from, of the stock after the pass), each piece
/// goes to the first move that comes to it, looked up in the middles of pieces no longer than the
/// lines are apart. So heights are as wrong as half of that, as boundaries between lines are, and
/// the volumes of moves add up to what was taken. `axial_mm` is along the lines, not the tool's
/// axis, `radial_mm` across the tip's way and level. Air is cut by a move that took no piece: one
/// that takes less than the lines are apart may take none. The same for any number of threads.
/// Throws std::invalid_argument for a pass without axes and for lines that are not the same,
/// Interrupted.
Removal turning_removal(const DexelStock& before, const DexelStock& after, const Pass& pass,
                        const model::RunControl& control);

}  // namespace limitgauge::simulator
