#pragma once

#include "reports/json/values.h"

namespace limitgauge::reports::json {

/// The path of a stage: "toolpath".
Json toolpath_part(const StageResult::Ran& r);

}  // namespace limitgauge::reports::json
