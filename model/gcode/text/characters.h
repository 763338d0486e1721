#pragma once

#include <string>

#include "model/base/characters.h"

namespace limitgauge::model::gcode {

/// For error messages: in quotes, or the byte's value where it cannot be printed.
std::string shown(char c);

}  // namespace limitgauge::model::gcode
