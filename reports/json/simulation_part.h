#pragma once

#include "reports/json/values.h"

namespace limitgauge::reports::json {

/// The cut of a stage and what was found in the process: "simulation".
Json simulation_part(const StageResult::Ran& r);

}  // namespace limitgauge::reports::json
