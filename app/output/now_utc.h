#pragma once

#include <string>

namespace limitgauge::app {

/// The time as ISO 8601, UTC, to the second: what stands in results as `created`.
std::string now_utc();

}  // namespace limitgauge::app
