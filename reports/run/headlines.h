#pragma once

#include <string>
#include <vector>

#include "reports/run/run_result.h"

namespace limitgauge::reports {

/// What keeps a stage from passing, a few words for each kind of failure in the order of weight:
/// "gouged beyond the limit", "holder in the material", "undecided: uncut". Of a stage that was not
/// run: that. Empty for one that passed.
std::vector<std::string> headlines(const StageResult& stage);

}  // namespace limitgauge::reports
