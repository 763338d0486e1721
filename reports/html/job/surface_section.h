#pragma once

#include <string>

#include "reports/run/run_result.h"

namespace limitgauge::reports::html {

/// What the design surface is: size, area, the rules that make it.
std::string surface_section(const SurfaceResult& surface);

}  // namespace limitgauge::reports::html
