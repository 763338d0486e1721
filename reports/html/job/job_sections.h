#pragma once

#include <string>
#include <vector>

#include "reports/run/run_result.h"

/// What the page tells of the job as a whole, section by section.
namespace limitgauge::reports::html {

/// What the design surface is: size, area, the rules that make it.
std::string surface_section(const SurfaceResult& surface);

/// What the toolpath engine needed: its model of the surface and the paths of the stages (the
/// paper's Tables 1 to 3), beside published figures of the same part where the job states them.
/// Empty where no stage was run.
std::string engine_section(const RunResult& result);
/// Whether there is such a section.
bool has_engine_section(const RunResult& result);

/// "block 90 × 80 × 30 mm"; escaped.
std::string stock_text(const model::Stock& stock);
/// Every tool that a stage uses, in all its measures.
std::string tools_section(const RunResult& result);
/// How the part lies in each setup; empty where the job states none.
std::string setups_section(const RunResult& result);
/// The job's own data, and all files that were read with their checksums.
std::string inputs_section(const RunResult& result);

/// The decision rule in words: that of a design, or that of the process alone.
std::string decision_section(bool has_design);
/// What was taken for granted; empty where nothing was.
std::string assumptions_section(const std::vector<std::string>& assumptions);

}  // namespace limitgauge::reports::html
