#include "simulator/process/process_limits.h"

#include <cmath>
#include <stdexcept>

namespace limitgauge::simulator {

void require_contact_limits(const ProcessLimits& limits) {
  if (!(limits.tolerance_mm > 0) || !std::isfinite(limits.tolerance_mm))
    throw std::invalid_argument("the tolerance of contacts must be a positive number");
  if (!(limits.near_miss_mm >= 0) || !std::isfinite(limits.near_miss_mm))
    throw std::invalid_argument("the clearance of near misses must be a number from 0 up");
}

}  // namespace limitgauge::simulator
