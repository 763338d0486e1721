#pragma once

#include <string>

#include "reports/run/run_result.h"

namespace limitgauge::reports::html {

/// The error map with its legend and the worst places marked, scaled by the gate; where everything
/// measured is far inside the limits, by what was measured.
std::string error_map(const StageResult& stage);

}  // namespace limitgauge::reports::html
