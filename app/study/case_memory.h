#pragma once

#include <cstddef>

#include "app/job/job.h"
#include "app/run/run_inputs.h"

namespace limitgauge::app {

/// What the memory of a case goes with.
struct CaseMemory {
  std::size_t grid_bytes = 0;   ///< of the raw stock's level set
  std::size_t model_bytes = 0;  ///< of the engine's model of the surface; 0 where no stage needs it

  /// What a process takes at its peak that runs this case and keeps stages of others like it.
  std::size_t forecast_bytes() const;
};
/// Builds both, on one thread, and lets go of them.
CaseMemory measure_case(const Job& job, const JobSurface& surface);

}  // namespace limitgauge::app
