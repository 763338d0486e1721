#pragma once

#include <vector>

#include "tests/defects/orientations/lying_result.h"

namespace limitgauge::tests::defects {

/// `twins` parts, half of them in setups and half on machines, and `defects` planted on them in
/// turn.
std::vector<LyingPlan> lying_plans(unsigned seed, std::size_t defects, std::size_t twins);

}  // namespace limitgauge::tests::defects
