#pragma once

#include "reports/json/values.h"

namespace limitgauge::reports::json {

/// What programs were told of the machine, and where their frame lies: "programs".
Json programs_part(const RunResult& result);

}  // namespace limitgauge::reports::json
