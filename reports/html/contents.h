#pragma once

#include <string>

#include "reports/run/run_result.h"

namespace limitgauge::reports::html {

/// A short table of contents: the page's sections and stages.
std::string contents(const RunResult& result);

}  // namespace limitgauge::reports::html
