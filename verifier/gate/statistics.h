#pragma once

#include "verifier/gate/deviation.h"

namespace limitgauge::verifier {

/// Fills in the area-weighted figures of `out` from its field: areas, coverage, mean, rms,
/// percentiles and histogram of deviation − allowance over the reachable samples.
void summarize_field(StageDeviation& out, const GateLimits& limits);

}  // namespace limitgauge::verifier
