#pragma once

#include "model/gcode/machine/machine_state.h"
#include "model/gcode/program.h"
#include "model/gcode/read/assumptions.h"
#include "model/gcode/text/statement.h"

namespace limitgauge::model::gcode {

/// For messages: `tool 2`, or that in the spindle, where no code has named it.
std::string loaded_name(const MachineState& state);
/// T: the tool that the next M6 brings.
void select_tool(const Statement& statement, MachineState& state);
/// M6 and M61: the tool's tip comes where the spindle is (Program::tip_places).
void change_tool(const Statement& statement, MachineState& state, Program& program,
                 Assumptions& assumed);
/// H and D where they stay until the next.
void take_offset_numbers(const Statement& statement, MachineState& state);
/// G43, G43.1, G43.2, G49, and D where it is the length's. H0 means the tool in the spindle, as in
/// LinuxCNC. None of them while cutter compensation is on.
void set_length_offset(const Statement& statement, MachineState& state, Assumptions& assumed);
/// Takes up a length offset that was saved, as LinuxCNC does: by G49, or by G43 for the tool that
/// is in the spindle now. False where it was one of G43.1 or G43.2, whose value is not saved.
bool restore_length_offset(MachineState& state, int code);
/// Behind a block of G28, G30 or G53: takes the tool's length out of effect where the control does
/// (LengthCancel). The code, in tenths, and the modal G43 stay.
void cancel_length(const Statement& statement, MachineState& state);
/// Of a motion along Z under a length that is out of effect so: lists it once.
void note_cancelled_length(const Statement& statement, MachineState& state, Assumptions& assumed);
/// A feed motion needs to know where the tip is: throws InputError where the length offset in use
/// is not that of the tool in the spindle and their lengths are not stated.
void check_tip(const Statement& statement, const MachineState& state);

}  // namespace limitgauge::model::gcode
