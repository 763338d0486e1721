#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "tests/defects/orientations/lying_bench.h"

namespace limitgauge::tests::defects {

/// `twins` parts, half of them in setups and half on machines, and `defects` planted on them in
/// turn.
std::vector<LyingPlan> lying_plans(unsigned seed, std::size_t defects, std::size_t twins);

/// A Markdown table by kind and one by what holds the part.
void write_lying_tables(std::ostream& out, const std::vector<LyingResult>& results);
/// One line a job that went wrong.
void write_lying_failures(std::ostream& out, const std::vector<LyingResult>& results);
/// One line a job, tab-separated.
void write_lying_cases(std::ostream& out, const std::vector<LyingResult>& results);

}  // namespace limitgauge::tests::defects
