#pragma once

#include "model/gcode/machine/machine_state.h"
#include "model/gcode/text/statement.h"

namespace limitgauge::model::gcode {

/// G93, G94, G95 and F, in LinuxCNC's order. Throws InputError for a rate out of range.
void set_feed(const Statement& statement, MachineState& state);

/// The feed rate of a motion of `length_mm`, mm/min; 0 where none was programmed. Throws InputError
/// in inverse time (G93) without F, per revolution (G95) without a constant spindle speed.
double feed_of(const Statement& statement, const MachineState& state, double length_mm);

}  // namespace limitgauge::model::gcode
