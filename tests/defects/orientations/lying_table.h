#pragma once

#include <ostream>
#include <vector>

#include "tests/defects/orientations/lying_result.h"

namespace limitgauge::tests::defects {

/// A Markdown table by kind and one by what holds the part.
void write_lying_tables(std::ostream& out, const std::vector<LyingResult>& results);
/// One line a job that went wrong.
void write_lying_failures(std::ostream& out, const std::vector<LyingResult>& results);
/// One line a job, tab-separated.
void write_lying_cases(std::ostream& out, const std::vector<LyingResult>& results);

}  // namespace limitgauge::tests::defects
