#pragma once

#include <string>

#include "reports/run/report.h"

namespace limitgauge::reports::html {

/// The stage's part of the page.
std::string stage_section(const RunResult& result, std::size_t index);
/// "contour", or the program's name; escaped.
std::string path_source(const StageResult& stage);
/// "⌀8 mm flat"; escaped.
std::string cutter_text(const model::Cutter& cutter);

}  // namespace limitgauge::reports::html
