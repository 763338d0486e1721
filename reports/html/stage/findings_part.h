#pragma once

#include <string>

#include "reports/run/run_result.h"

namespace limitgauge::reports::html {

/// Gouges and leftovers of a stage that ran, the worst first, and what each body of the assembly
/// did to the part.
std::string findings_part(const RunResult& result, std::size_t index);

}  // namespace limitgauge::reports::html
