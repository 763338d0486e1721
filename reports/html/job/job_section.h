#pragma once

#include <string>

#include "reports/run/run_result.h"

namespace limitgauge::reports::html {

/// "block 90 × 80 × 30 mm"; escaped.
std::string stock_text(const model::Stock& stock);
/// Every tool that a stage uses, in all its measures.
std::string tools_section(const RunResult& result);
/// The job's own data, and all files that were read with their checksums.
std::string inputs_section(const RunResult& result);

}  // namespace limitgauge::reports::html
