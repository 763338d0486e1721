#pragma once

#include "reports/run/run_result.h"

namespace limitgauge::reports {

/// The failed sample with markup, script and link schemes in every text that a job, a cage or a
/// program can bring in. Whatever of them runs sets `window.hostile`.
RunResult hostile_result();

}  // namespace limitgauge::reports
