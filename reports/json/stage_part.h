#pragma once

#include "reports/json/values.h"

namespace limitgauge::reports::json {

/// One entry of "stages".
Json stage_part(const RunResult& result, std::size_t index);

}  // namespace limitgauge::reports::json
