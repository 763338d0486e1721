#pragma once

#include "reports/json/values.h"

/// The parts of result.json.
namespace limitgauge::reports::json {

/// The files that were read: "inputs".
Json inputs_part(const std::vector<InputFile>& inputs);

/// What programs were told of the machine, and where their frame lies: "programs".
Json programs_part(const RunResult& result);

/// How the part lies in each setup: "setups".
Json setups_part(const std::vector<model::Setup>& setups);

/// The raw stock: "stock".
Json stock_part(const model::Stock& stock);

/// The design surface: "surface".
Json surface_part(const SurfaceResult& s);

/// One entry of "stages".
Json stage_part(const RunResult& result, std::size_t index);

/// The path of a stage: "toolpath".
Json toolpath_part(const StageRun& r);

/// What the processes were checked by: "process_limits".
Json process_limits_part(const record::ProcessLimits& limits);

/// The cut of a stage and what was found in the process: "simulation".
Json simulation_part(const StageRun& r);

/// What was measured of a stage: "deviation".
Json deviation_part(const RunResult& result, const verifier::StageDeviation& d,
                    const verifier::GateLimits& limits);

/// What is certified over tolerances: "robust" of a stage.
Json robust_part(const RunResult& result, const verifier::RobustDeviation& robust,
                 const verifier::GateLimits& limits);

/// "tolerances", as they were stated.
Json tolerances_part(const model::Tolerances& tolerances);

}  // namespace limitgauge::reports::json
