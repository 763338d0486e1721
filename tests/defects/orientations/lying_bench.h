#pragma once

#include <string>
#include <vector>

#include "tests/defects/orientations/lying_result.h"

namespace limitgauge::tests::defects {

/// The twin's result first. Each job is a file that the built program runs; all files are kept
/// below `keep` where that is not empty.
std::vector<LyingResult> run_lying(const LyingPlan& plan, const std::string& keep);

}  // namespace limitgauge::tests::defects
