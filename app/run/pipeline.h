#pragma once

#include <filesystem>
#include <functional>
#include <memory>

#include "app/inputs/run_inputs.h"
#include "app/job/job.h"
#include "app/run/run_watch.h"
#include "reports/run/run_result.h"

namespace limitgauge::app {

struct StagePrefix;

/// Where a run goes on from, and whom it tells how far it is.
struct Resumption {
  /// State after the first stages of a job that begins with the same ones, its stock with it unless
  /// it is over; of no stages, it may hold a model. Nothing: from the first stage on.
  std::shared_ptr<const StagePrefix> from;
  /// The state after each stage that was run; the call may keep a copy.
  std::function<void(const StagePrefix& state)> after_stage = {};
};

/// Runs the job's stages into `folder`: path, cut, measurement, gate; the files of a stage are
/// written as soon as it has been judged. Stops after a stage that does not pass; the later ones
/// are then `not_run`. Throws InputError for a stage that cannot be planned, ResourceError,
/// Interrupted, verifier::InstrumentDisagreement.
reports::RunResult run_job(const Job& job, const RunInputs& inputs,
                           const std::filesystem::path& folder, const RunOptions& options,
                           const Resumption& resumption = {});

/// Plans the job's stages into `folder`: toolpath.ngc and toolpath.vtp a stage.
void plan_job(const Job& job, const RunInputs& inputs, const std::filesystem::path& folder,
              const RunOptions& options);

/// result.json, junit.xml and report.html into `folder`. Throws ResourceError.
void write_report(const reports::RunResult& result, const std::filesystem::path& folder,
                  unsigned threads);

}  // namespace limitgauge::app
