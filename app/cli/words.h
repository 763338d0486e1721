#pragma once

#include <string>

namespace limitgauge::app {

/// `value` in the fewest digits that read back as the same number.
std::string words(double value);

}  // namespace limitgauge::app
