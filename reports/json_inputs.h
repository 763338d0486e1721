#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "reports/run_result.h"

namespace limitgauge::reports {

/// The files that were read, for result.json: role, file, bytes, sha256.
nlohmann::ordered_json inputs_json(const std::vector<InputFile>& inputs);

}  // namespace limitgauge::reports
