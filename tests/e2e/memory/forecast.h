#pragma once

#include "tests/e2e/program.h"

namespace limitgauge::e2e {

/// Checks that a run with --verbose took as much memory as it said before it planned or cut
/// anything, within a factor of 1.5 either way: what is promised of a forecast (docs/simulator.md).
void check_forecast(const Outcome& outcome);

}  // namespace limitgauge::e2e
