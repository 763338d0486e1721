#pragma once

#include "engine/model/gcode/cutter_compensation.h"
#include "engine/model/gcode/machine_state.h"
#include "engine/model/gcode/statement.h"

namespace limitgauge::model::gcode {

/// G40, G41, G42, G41.1 and G42.1. Without D or with D0 the diameter is that of the tool in the
/// spindle, as in LinuxCNC. Throws InputError where that is not stated.
void set_radius_offset(const Statement& statement, MachineState& state,
                       CutterCompensation& compensation);

}  // namespace limitgauge::model::gcode
