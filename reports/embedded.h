#pragma once

#include <string_view>

/// Files of this folder that are built into the program (see embed.cmake).
namespace limitgauge::reports::embedded {

std::string_view result_schema();
std::string_view report_css();

}  // namespace limitgauge::reports::embedded
