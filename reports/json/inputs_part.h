#pragma once

#include "reports/json/values.h"

namespace limitgauge::reports::json {

/// The files that were read: "inputs".
Json inputs_part(const std::vector<InputFile>& inputs);

}  // namespace limitgauge::reports::json
