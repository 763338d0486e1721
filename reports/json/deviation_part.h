#pragma once

#include "reports/json/values.h"

namespace limitgauge::reports::json {

/// What was measured of a stage: "deviation".
Json deviation_part(const RunResult& result, const verifier::StageDeviation& d);

}  // namespace limitgauge::reports::json
