#pragma once

#include <string>

#include "reports/study/study_view.h"

/// The parts of study.html, as markup.
namespace limitgauge::reports::study_report {

/// Name, the setting to take with its reason, counts, and what the study is of.
std::string masthead(const StudyView& view);
/// Where the script draws; without it the sections that follow say the same.
std::string charts_section(const StudyView& view);
/// What accuracy costs: a table a front.
std::string fronts_section(const StudyView& view);
/// What each key does to each figure, the strongest first.
std::string sensitivity_section(const StudyView& view);
/// The cases to look at first.
std::string cases_section(const StudyView& view);
/// Why cases did not pass: the same reason once, with its cases.
std::string reasons_section(const StudyView& view);
/// What was varied, and how cases were chosen.
std::string design_section(const StudyView& view);
/// What the page's script reads, format `limitgauge.study-page/1` (see reports/web/README.md).
std::string page_data(const StudyView& view);

}  // namespace limitgauge::reports::study_report
