#pragma once

#include "model/gcode/cycles/cutter_compensation.h"
#include "model/gcode/machine/machine_state.h"
#include "model/gcode/read/assumptions.h"
#include "model/gcode/text/statement.h"

namespace limitgauge::model::gcode {

/// G40, G41, G42, G41.1 and G42.1. Without D or with D0 the diameter is that of the tool in the
/// spindle, as in LinuxCNC; under Siemens's D0 there is none. What a control's settings decide goes
/// among `assumed`. Throws InputError where the diameter is not stated.
void set_radius_offset(const Statement& statement, MachineState& state,
                       CutterCompensation& compensation, Assumptions& assumed);

}  // namespace limitgauge::model::gcode
