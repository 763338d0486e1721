#pragma once

#include <span>
#include <string>
#include <vector>

#include "reports/study/study_view.h"

namespace limitgauge::reports::study_report {

/// A table of cases: number, status, settings, and the figures that are asked for. `anchored`: its
/// rows are those that links of the page go to.
std::string case_table(const StudyView& view, const std::string& caption,
                       std::span<const std::size_t> rows, std::span<const std::size_t> figures,
                       bool anchored);

}  // namespace limitgauge::reports::study_report
