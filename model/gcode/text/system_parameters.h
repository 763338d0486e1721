#pragma once

#include <optional>
#include <string_view>

#include "model/gcode/machine/machine_state.h"

namespace limitgauge::model::gcode {

/// What LinuxCNC keeps in numbered parameters from 5021 on: stored positions and offsets in the
/// machine's unit, mm; the position in the program's. Nothing for what it does not have, or what
/// neither machine nor program states. The reads of probes and inputs (5061 to 5070, 5399) are
/// never set.
/// Source: linuxcnc.org, "Numbered Parameters".
std::optional<double> system_parameter(const MachineState& state, int number);

/// Its predefined named parameters, `_x` and the like; `call_level` is that of the running
/// subroutine. Source: linuxcnc.org, "Predefined Named Parameters".
std::optional<double> system_parameter(const MachineState& state, std::string_view name,
                                       std::size_t call_level);

}  // namespace limitgauge::model::gcode
