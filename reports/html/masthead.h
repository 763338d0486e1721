#pragma once

#include <string>

#include "reports/run/run_result.h"

namespace limitgauge::reports::html {

/// The page's header: the verdict, the worst places of a job that did not pass with depth, place
/// and program line, the reasons, what was verified.
std::string masthead(const RunResult& result);

/// A short table of contents: the page's sections and stages.
std::string contents(const RunResult& result);

}  // namespace limitgauge::reports::html
