#pragma once

#include <vector>

#include "study/plan/plan.h"

namespace limitgauge::study {

/// Number of cases that design() makes of `plan` (of a search: that it may take at most); the
/// largest number there is where it would not fit into one.
std::size_t case_count(const Plan& plan);

/// The cases of a plan that is no search, always the same for the same plan, no two alike. Throws
/// std::invalid_argument for a plan that the reader would not let through.
std::vector<Case> design(const Plan& plan);

}  // namespace limitgauge::study
