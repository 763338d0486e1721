#pragma once

#include "app/inputs/run_inputs.h"
#include "app/job/job.h"
#include "app/run/run_watch.h"
#include "app/run/stage_prefix.h"
#include "reports/run/run_result.h"

namespace limitgauge::app {

/// What a result says of a job before anything is computed; its stages as asked for.
reports::RunResult result_as_asked(const Job& job, const RunInputs& inputs,
                                   const RunOptions& options);
/// Puts a stage of an earlier run into the place of the one as asked for.
void take_up(const RecordedStage& recorded, reports::StageResult& stage);
/// What a run of these first stages leaves to others that begin with them.
std::vector<RecordedStage> recorded_stages(const reports::RunResult& result);
/// The figures of the surface that follow from the stages; those of the engine's model where there
/// are any.
void finish_surface(reports::RunResult& result,
                    const std::optional<engine::surface::ModelFigures>& figures);

}  // namespace limitgauge::app
