#pragma once

#include <string>

#include "reports/run/run_result.h"

namespace limitgauge::reports::html {

/// What the toolpath engine needed: its model of the surface and the paths of the stages (the
/// paper's Tables 1 to 3), beside published figures of the same part where the job states them.
/// Empty where no stage was run.
std::string engine_section(const RunResult& result);
/// Whether there is such a section.
bool has_engine_section(const RunResult& result);

}  // namespace limitgauge::reports::html
