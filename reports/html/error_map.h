#pragma once

#include <string>

#include "reports/run_result.h"

namespace limitgauge::reports::html {

/// The error map scaled by the gate with its legend and the worst places marked; where everything
/// measured is far inside the limits, a second map at the scale of what was measured.
std::string error_maps(const StageResult& stage);

}  // namespace limitgauge::reports::html
