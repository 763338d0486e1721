#pragma once

#include <string>

namespace limitgauge::app {

/// "2026-11-22T01:40:00Z": the clock, as results name it.
std::string now_utc();

}  // namespace limitgauge::app
