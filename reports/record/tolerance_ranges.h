#pragma once

#include <map>
#include <string>

#include "model/part/tolerances.h"

namespace limitgauge::reports::record {

/// By "zero.x", "tool.ball3.radius": mm about the stated value. What cannot differ is not there.
using ToleranceRanges = std::map<std::string, model::Interval>;
ToleranceRanges tolerance_ranges(const model::Tolerances& tolerances);

}  // namespace limitgauge::reports::record
