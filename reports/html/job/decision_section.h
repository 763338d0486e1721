#pragma once

#include <string>
#include <vector>

namespace limitgauge::reports::html {

/// The decision rule in words.
std::string decision_section();
/// What was taken for granted; empty where nothing was.
std::string assumptions_section(const std::vector<std::string>& assumptions);

}  // namespace limitgauge::reports::html
