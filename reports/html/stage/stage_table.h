#pragma once

#include <string>

#include "reports/run/run_result.h"

namespace limitgauge::reports::html {

/// One row a stage with its gate figures and verdict.
std::string stage_table(const RunResult& result);

}  // namespace limitgauge::reports::html
