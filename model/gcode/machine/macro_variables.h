#pragma once

#include <optional>

#include "model/gcode/machine/machine_state.h"

namespace limitgauge::model::gcode {

/// System variables of macro B as far as they follow from program and machine: positions (5001 to
/// 5003, 5021 to 5023, 5041 to 5043), work offsets (5221 on), modal codes (4001 on), Haas's tool
/// offsets (2001 on, 2401 on). Lengths in the program's unit. Nothing for what is not known here:
/// it is an error where it is read. Sources: B-63684EN, 16.2; Haas 96-8210, "System Variables".
std::optional<double> macro_variable(const MachineState& state, Control control, int number);

}  // namespace limitgauge::model::gcode
