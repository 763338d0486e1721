#pragma once

#include <string>

#include "reports/run/run_result.h"

namespace limitgauge::reports::html {

/// The patches of a stage that ran, the worst first, folded away where there are many.
std::string patch_table(const RunResult& result, std::size_t index);

}  // namespace limitgauge::reports::html
