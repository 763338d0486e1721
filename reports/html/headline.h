#pragma once

#include <string>

#include "reports/run/run_result.h"

namespace limitgauge::reports::html {

/// What the verdict rests on: a sentence where every stage passed, else a line for each stage that
/// did not, with what kept it.
std::string verdict_lines(const RunResult& result);

/// What no cutter reaches and what stock is missing, of every stage: a verdict says nothing of it.
std::string notes_list(const RunResult& result);

/// What keeps stages from passing and has no place of its own: coverage, reach. Where no figure
/// explains a verdict, the gate's reasons as they are.
std::string placeless_reasons(const RunResult& result);

}  // namespace limitgauge::reports::html
