#pragma once

#include "model/base/run_control.h"
#include "simulator/instrument/dexel_stock.h"
#include "simulator/stock/stock_model.h"

namespace limitgauge::simulator {

/// The dexels of what stands in `stock`, in its frame: for a setup that takes a part over from
/// another one. Each line is walked upwards through the raw stock by rays (StockRays). Lines as
/// DexelStock(raw, spacing) has them.
///
/// An end lies on the exact surface within kTakenOver_mm: |φ| at it is no more than that. What is
/// thinner than kLeastFeature_mm along the line is passed over. The same for any number of threads.
/// Throws as that constructor does, and Interrupted.
///
/// Dexels that are taken from the level set are no check of it. What keeps both independent over a
/// change of setup: every pass is cut by dexels of its own setup, upright, which the level set is
/// held against there; the level set of the next setup, for which the same passes are cut again
/// turned, is held against the dexels of the setup before (compare_stocks with a pose); only from
/// one that agrees are the next dexels taken, and they go on by themselves.
DexelStock dexels_from(const StockModel& stock, double spacing_mm,
                       const model::RunControl& control);

}  // namespace limitgauge::simulator
