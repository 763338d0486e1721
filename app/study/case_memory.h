#pragma once

#include <atomic>
#include <cstddef>
#include <optional>

#include "app/inputs/run_inputs.h"
#include "app/job/job.h"

namespace limitgauge::app {

/// Of a process that runs cases: it writes no files, and keeps stages of the cases before.
RunTerms case_terms(std::size_t memory_limit_bytes);

/// What it takes at its peak with this case (forecast_bytes). Builds stock and model for it, on one
/// thread, and lets go of them.
double case_forecast_bytes(const Job& job, std::optional<JobSurface> surface,
                           std::size_t memory_limit_bytes, const std::atomic<bool>* stop = nullptr);

}  // namespace limitgauge::app
