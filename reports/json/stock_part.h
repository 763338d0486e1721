#pragma once

#include "reports/json/values.h"

namespace limitgauge::reports::json {

/// The raw stock: "stock".
Json stock_part(const model::Stock& stock);

}  // namespace limitgauge::reports::json
