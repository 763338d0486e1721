#pragma once

#include <cstddef>
#include <string>

#include "reports/run/run_result.h"

namespace limitgauge::reports::html {

/// Faults and near misses of the process, runs of moves with the same one as a row; a sentence
/// where there is none.
std::string process_table(const StageResult::Ran& ran, std::size_t stage);
/// Where the page's script puts charts over the program: removal rate, feed, engagement.
std::string process_charts(std::size_t stage);
/// How deep, or how far apart for a near miss: "≥ 0.84 mm".
std::string process_depth(const simulator::Finding& finding);
/// What was removed and how: rates, engagement, air cutting.
std::string removal_terms(const StageResult::Ran& ran);

}  // namespace limitgauge::reports::html
