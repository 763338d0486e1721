#pragma once

#include <string>

#include "reports/run/run_result.h"

namespace limitgauge::reports::html {

/// For the header: of each stage that did not pass the worst gouge, leftover or process fault with
/// its depth, its place, its program line in full, and a link to its row. Empty for a job that
/// passed.
std::string worst_places(const RunResult& result);

}  // namespace limitgauge::reports::html
