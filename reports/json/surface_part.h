#pragma once

#include "reports/json/values.h"

namespace limitgauge::reports::json {

/// The design surface: "surface".
Json surface_part(const SurfaceResult& s);

}  // namespace limitgauge::reports::json
