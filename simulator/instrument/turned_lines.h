#pragma once

#include "model/base/run_control.h"
#include "simulator/instrument/dexel_stock.h"
#include "simulator/stock/stock_model.h"

namespace limitgauge::simulator {

/// The second stock model where a part has just been turned over: vertical lines of the new frame
/// through the level set `stock`, at most `spacing_mm` apart, their ends where the exact material
/// begins and ends, good to kLeastFeature_mm. Thinner gaps and slices are passed over.
///
/// Lines know only of upright cutters, so they cannot cut what other setups cut; the level set can.
/// Two models stay two all the same: every pass is cut by lines of its own setup, where its cutter
/// is upright; a level set that holds it turned is held against those lines (compare_stocks with
/// the pose) before lines are taken from it; and what they are cut by from then on is upright.
/// Throws Interrupted.
DexelStock turned_lines(const StockModel& stock, double spacing_mm,
                        const model::RunControl& control);

}  // namespace limitgauge::simulator
