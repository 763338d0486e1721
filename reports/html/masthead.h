#pragma once

#include <string>

#include "reports/run/run_result.h"

namespace limitgauge::reports::html {

/// The page's header: the verdict, what kept a job from passing by kind, the worst places with
/// depth, place and program line, what is out of reach, what was verified.
std::string masthead(const RunResult& result);

/// A short table of contents: the page's sections and stages.
std::string contents(const RunResult& result);

}  // namespace limitgauge::reports::html
