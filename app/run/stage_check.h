#pragma once

#include "app/inputs/run_inputs.h"
#include "app/job/job.h"
#include "verifier/gate/verify.h"

namespace limitgauge::app {

/// What a stage is measured for, in a job with a design.
inline verifier::StageCheck stage_check(const Job& job, const RunInputs& inputs,
                                        std::size_t index) {
  verifier::StageCheck check;
  check.allowance_mm = job.stages[index].allowance_mm;
  check.limits = job.stages[index].limits;
  check.resolution_mm = inputs.settings.resolution_mm[index];
  check.tolerances = job.tolerances;
  check.finds_margin = job.finds_margin;
  for (const std::size_t i : finer_stages(job, index))
    check.finer_passes.push_back({i, job.stages[i].allowance_mm, job.stages[i].limits.gouge_mm});
  return check;
}

}  // namespace limitgauge::app
