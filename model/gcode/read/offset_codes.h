#pragma once

#include "model/gcode/machine/machine_state.h"
#include "model/gcode/read/assumptions.h"
#include "model/gcode/text/statement.h"

namespace limitgauge::model::gcode {

/// G54 to G59.3.
void select_system(const Statement& statement, MachineState& state, Assumptions& assumed);
/// G10 L1, L2 and L20; like G92, L20 may say of an axis that nothing stated where it stands, and
/// `program` keeps it (Program::start_said_mm). Throws InputError for other L words and values out
/// of range.
void set_data(const Statement& statement, MachineState& state, Program& program,
              Assumptions& assumed);
/// G92 and G52.
void set_axis_offsets(const Statement& statement, MachineState& state, Program& program,
                      Assumptions& assumed);
/// G92.1, G92.2 and G92.3.
void apply_axis_offsets(const Statement& statement, MachineState& state);

}  // namespace limitgauge::model::gcode
