#pragma once

#include <span>
#include <string>
#include <vector>

#include "reports/record/run_record.h"
#include "study/store/table.h"

/// What a study takes from the result of a case.
namespace limitgauge::app {

/// The figures of jobs with these stages: `machining_time_s` and `gate_excess` of the whole run,
/// then of each stage what reports/record lists, as STAGE.METRIC or, of certified figures,
/// STAGE.METRIC.low and .high. Nothing that another machine would measure otherwise is among them.
std::vector<study::Figure> study_figures(std::span<const std::string> stages);

/// Ids of those that are to be small, and so can be a cost or an accuracy.
std::vector<std::string> objective_ids(std::span<const std::string> stages);

/// How far the run is from passing, as a share of the limit that is worst kept: the largest
/// (certified high - limit) / limit of all stages that were run, of coverage the excess of what is
/// not covered over what may be. At most 0 where every gate passes, above 0 where one does not. A
/// stage that fails for anything else (collisions, for one) counts with the number of those faults.
/// Nothing where no gate has a limit and nothing failed.
std::optional<double> gate_excess(const reports::record::RunRecord& run);

/// Status, reason and figures of a case that came to a result. The reason names the stage and the
/// limits, and no measured figures: cases that fail alike say so alike.
void fill_row(study::Row& row, const reports::record::RunRecord& run,
              std::span<const std::string> stages);

}  // namespace limitgauge::app
