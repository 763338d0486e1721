#pragma once

#include <span>
#include <string>

#include "reports/run_result.h"

namespace limitgauge::reports::html {

/// Faults and near misses of the process, runs of moves with the same one as a row; a sentence
/// where there is none.
std::string process_table(std::span<const simulator::Finding> findings);
/// What was removed and how: rates, engagement, air cutting.
std::string removal_terms(const StageResult::Ran& ran);

}  // namespace limitgauge::reports::html
