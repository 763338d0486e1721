#pragma once

#include <string>
#include <string_view>

#include "app/usage/command_reference.h"

namespace limitgauge::app {

/// The manual page limitgauge(1), in the macros of man(7).
std::string man_page(const CommandReference& program, std::string_view version);

}  // namespace limitgauge::app
