#pragma once

#include <span>
#include <string>
#include <vector>

#include "app/job/job.h"
#include "reports/record/run_record.h"
#include "study/store/table.h"

/// What a study takes from the result of a case.
namespace limitgauge::app {

/// What the cases of a study have figures of.
struct FigureScope {
  std::vector<std::string> stages;
  /// Cases may state tolerances: each stage then has the figures over them and the margin, which a
  /// case without has not.
  bool over_tolerances = false;
};
/// Of a job as it stands before the `keys` are varied.
FigureScope figure_scope(const Job& job, std::span<const std::string> keys);

/// The figures of such cases: `machining_time_s` and `gate_excess` of the whole run,
/// then of each stage what reports/record lists, as STAGE.METRIC or, of certified figures,
/// STAGE.METRIC.low and .high. Nothing that another machine would measure otherwise is among them.
std::vector<study::Figure> study_figures(const FigureScope& scope);

/// Ids of those that can be a cost or an accuracy: those that are to be small, and margins as far
/// as they are proven, which are to be large.
std::vector<std::string> objective_ids(const FigureScope& scope);

/// How far the run is from passing, as a share of the limit that is worst kept: the largest
/// (certified high - limit) / limit of all stages that were run (over the tolerances, where some
/// are stated), of coverage the excess of what is not covered over what may be. At most 0 where
/// every gate passes, above 0 where one does not. A stage that fails for anything else (collisions,
/// for one) counts with the number of those faults. Nothing where no gate has a limit and nothing
/// failed.
std::optional<double> gate_excess(const reports::record::RunRecord& run);

/// Status, reason and figures (those of study_figures()) of a case that came to a result. The
/// reason names the stage and the limits, and no measured figures: cases that fail alike say so
/// alike.
void fill_row(study::Row& row, const reports::record::RunRecord& run, const FigureScope& scope);

}  // namespace limitgauge::app
