#pragma once

#include <span>
#include <vector>

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
  /// The volume is of this stock as it lay in a setup before: an estimate of the same, but not one
  /// to take another from.
  bool volume_is_older = false;
};

/// What the shape that is left does not show: collisions and the like of `pass`, `asked`'s, on the
/// stock as it stands before.
std::vector<simulator::Finding> process_findings(const Job& job, const RunInputs& inputs,
                                                 const JobStage& asked,
                                                 const simulator::StockModel& stock,
                                                 const simulator::Pass& pass,
                                                 const StageWatch& watch);

/// Before the first stage.
CutStock uncut_stock(const Job& job, const Settings& settings, const StageWatch& watch);

/// `before` after `passes`, of which nothing else is wanted: the same to the last bit as they left
/// it when they were first cut.
CutStock cut_again(CutStock before, std::span<const model::Pass> passes, const Settings& settings,
                   const StageWatch& watch);

/// How a stock comes to lie otherwise: all passes so far in the new frame, and how the old frame
/// lies in it.
struct StockTurn {
  std::vector<model::Pass> passes;
  model::Pose turn;
};
/// `before` as it lies in another setup, whose view of the job is `job`: the level set is cut again
/// there by the turned passes and held against the lines of the old setup before it is believed;
/// the lines of the new one are then taken from it. Throws InstrumentDisagreement where the two
/// stock models contradict each other, ResourceError, Interrupted.
CutStock turned_over(const Job& job, const Settings& settings, const CutStock& before,
                     const StockTurn& turn, const StageWatch& watch);

/// Cuts the path of `ran`, whose figures of the cut and of the process it fills in. The volume is
/// added up again only where a path removes something: a stretch that positions leaves it. A stock
/// that nobody shares is cut where it stands. Throws InstrumentDisagreement where the two stock
/// models contradict each other, ResourceError, Interrupted.
CutStock cut_stage(const Job& job, const RunInputs& inputs, const JobStage& asked, CutStock before,
                   const StageWatch& watch, reports::StageRun& ran);

/// Of a stretch that only positions and comes near nothing of the block that all is cut from: its
/// process, with `stock` left as it lies, in whatever setup's frame. `job` and `inputs` are the
/// view of the stretch's own setup. False, and nothing filled in, where it may meet something: then
/// the stock has to be turned and cut. Throws as cut_stage() does.
bool passes_by(const Job& job, const RunInputs& inputs, const JobStage& asked,
               const CutStock& stock, const StageWatch& watch, reports::StageRun& ran);

}  // namespace limitgauge::app
