#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/cli/command.h"
#include "model/base/run_control.h"
#include "model/part/toolpath.h"
#include "reports/probe/probe_result.h"
#include "verifier/cutter/removed_space.h"

namespace limitgauge::app {

/// The simulated stock after a stage of a result, made again from the result's own files: the raw
/// stock less what every stage up to that one sweeps. Moves are read to the last bit.
struct ResultStock {
  std::string job, version;
  std::string sha256;                                      ///< of result.json
  verifier::Verdict verdict = verifier::Verdict::not_run;  ///< of the last stage below
  std::vector<reports::probe::CutBy> stages;
  std::vector<model::Pass> passes;  ///< beside stages
  verifier::RemovedSpace removed;
  std::vector<std::string> remarks;
};

/// Throws InputError for what is no result, for a stage that is none or was not run, and for a file
/// of it that is missing or is not as its manifest says; Interrupted.
ResultStock read_result_stock(const ProbeCommand& command, const model::RunControl& control);

}  // namespace limitgauge::app
