#pragma once

#include <string>

#include "reports/run/run_result.h"

namespace limitgauge::reports {

/// A stage that ran as result.json has it, for StageResult::recorded of another run that begins
/// with the same stages.
std::string recorded_stage(const RunResult& result, std::size_t index);
/// Whether `text` can be one.
bool is_recorded_stage(const std::string& text);

}  // namespace limitgauge::reports
