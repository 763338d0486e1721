#pragma once

#include "model/gcode/machine/machine_state.h"
#include "model/gcode/read/assumptions.h"
#include "model/gcode/text/statement.h"

namespace limitgauge::model::gcode {

/// Where G53's words lead, in the active work frame. A rapid to Z0 alone, while nothing states
/// where the machine's zero lies, leaves Z parked above everything; any other motion is an error
/// then.
Vec3 machine_end(const Statement& statement, MachineState& state, bool rapid, Assumptions& assumed);

/// The second motion of G28 and G30, from their intermediate point: the axes of the block, or all
/// where it has none, go to the stored position; those that nothing states are adrift then.
/// Throws InputError where X or Y would be so while Z is not above everything.
Vec3 reference_end(const Statement& statement, MachineState& state, Assumptions& assumed);

/// G28.1 and G30.1: the position becomes the stored one.
void store_reference(const Statement& statement, MachineState& state);

}  // namespace limitgauge::model::gcode
