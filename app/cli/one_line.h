#pragma once

#include <string>

namespace limitgauge::app {

/// A message of several lines as one: its parts joined by "; ".
std::string one_line(std::string text);

}  // namespace limitgauge::app
