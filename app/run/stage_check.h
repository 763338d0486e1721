#pragma once

#include <algorithm>
#include <cmath>

#include "app/inputs/run_inputs.h"
#include "app/job/job.h"
#include "verifier/gate/verify.h"

namespace limitgauge::app {

/// How far samples of the deviation lie apart: a map, whose figures the certificate does not rest
/// on. On a surface of more than 1250 cm² as far as two million samples cover it: 500 MB, by what a
/// sample takes with all that is made of it.
inline double field_spacing_mm(double area_mm2) {
  constexpr double kFinest_mm = 0.25, kMostSamples = 2e6;
  return std::max(kFinest_mm, std::ceil(std::sqrt(area_mm2 / kMostSamples) * 100) / 100);
}

/// What a stage is measured for, in a job with a design.
inline verifier::StageCheck stage_check(const Job& job, const RunInputs& inputs,
                                        std::size_t index) {
  verifier::StageCheck check;
  check.allowance_mm = job.stages[index].allowance_mm;
  check.limits = job.stages[index].limits;
  check.resolution_mm = inputs.settings.resolution_mm[index];
  check.field_spacing_mm = field_spacing_mm(inputs.design->surface.area_mm2());
  check.tolerances = job.tolerances;
  check.finds_margin = job.finds_margin;
  for (const std::size_t i : finer_stages(job, index))
    check.finer_passes.push_back({i, job.stages[i].allowance_mm, job.stages[i].limits.gouge_mm});
  return check;
}

}  // namespace limitgauge::app
