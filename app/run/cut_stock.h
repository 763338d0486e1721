#pragma once

#include <span>

#include "app/inputs/run_inputs.h"
#include "app/job/job.h"
#include "app/run/run_watch.h"
#include "reports/run/run_result.h"
#include "simulator/instrument/dexel_stock.h"
#include "simulator/stock/stock_model.h"
#include "verifier/gate/verify.h"

namespace limitgauge::app {

/// What stands between two stages, by both stock models. A value, cheap to copy.
struct CutStock {
  simulator::StockModel stock;
  double volume_mm3 = 0;  ///< of `stock`
  simulator::DexelStock lines;
};

/// Before the first stage.
CutStock uncut_stock(const Job& job, const Settings& settings, const StageWatch& watch);

/// `before` after `passes`, of which nothing else is wanted: the same to the last bit as they left
/// it when they were first cut.
CutStock cut_again(CutStock before, std::span<const model::Pass> passes, const StageWatch& watch);

/// Cuts the path of `ran`, whose figures of the cut and of the process it fills in. A stock that
/// nobody shares is cut where it stands. Throws InstrumentDisagreement where the two stock models
/// contradict each other, ResourceError, Interrupted.
CutStock cut_stage(const Job& job, const RunInputs& inputs, const JobStage& asked, CutStock before,
                   const StageWatch& watch, reports::StageResult::Ran& ran);

}  // namespace limitgauge::app
