#pragma once

#include "model/gcode/cycles/cutter_compensation.h"
#include "model/gcode/machine/machine_state.h"
#include "model/gcode/text/statement.h"

namespace limitgauge::model::gcode {

/// G40, G41, G42, G41.1 and G42.1. Without D or with D0 the diameter is that of the tool in the
/// spindle, as in LinuxCNC. Throws InputError where that is not stated.
void set_radius_offset(const Statement& statement, MachineState& state,
                       CutterCompensation& compensation);

}  // namespace limitgauge::model::gcode
