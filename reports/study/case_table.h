#pragma once

#include <span>
#include <string>
#include <vector>

#include "reports/study/study_view.h"

namespace limitgauge::reports::study_report {

/// Its number, leading to its result where it has one; markup.
std::string case_link(const StudyView& view, std::size_t row);
/// A table of cases: number, status, settings, and the figures that are asked for.
std::string case_table(const StudyView& view, const std::string& caption,
                       std::span<const std::size_t> rows, std::span<const std::size_t> figures);

}  // namespace limitgauge::reports::study_report
