#pragma once

#include <string>

#include "reports/run/run_result.h"

namespace limitgauge::reports::html {

/// What is told in single figures of a stage that ran: deviation, toolpath, simulation, removal.
std::string figures_part(const StageResult::Ran& ran);
/// Worst-case bounds of all sources of error.
std::string budget_table(const std::vector<verifier::UncertaintyTerm>& budget);

}  // namespace limitgauge::reports::html
