#pragma once

#include <string>

#include "reports/run/run_result.h"

namespace limitgauge::reports::html {

/// The program text around every line that the findings of stage `index` name, the lines marked
/// with the findings' numbers; empty where there is none.
std::string program_part(const RunResult& result, std::size_t index);
/// The file that holds the stage's program; escaped.
std::string program_file(const StageResult& stage);

}  // namespace limitgauge::reports::html
