#pragma once

#include <string>

#include "reports/run/run_result.h"

namespace limitgauge::reports::html {

/// Gouge and uncut of a stage that ran as bars against their limits, then coverage and collisions
/// in words.
std::string gate_part(const StageResult& stage);

}  // namespace limitgauge::reports::html
