#pragma once

#include <optional>

#include "model/gcode/machine/machine_state.h"
#include "model/gcode/read/assumptions.h"
#include "model/gcode/text/statement.h"

namespace limitgauge::model::gcode {

/// The word of the block that turns the tool: A, B or C, under G43.5 I, J or K; or nothing.
const Word* turning_word(const Statement& statement, const MachineState& state);
/// Where such words of the block lead, G90 or G91. Throws InputError for an angle that no control
/// counts, and for a direction that no angles within the limits put the tool along.
RotaryAngles rotary_end(const Statement& statement, const MachineState& state);

/// G49 ends what G43.4 began, where the control has it; before the length offset is let go.
void leave_tool_centre(const Statement& statement, MachineState& state);
/// Throws InputError for another code of the same group, as G43, while places are the tip's: what a
/// control then makes of them no manual that was at hand says.
void forbid_in_tool_centre(const Statement& statement, const MachineState& state);
/// G43.4, G43.5 and G234, once their length offset is in use.
void enter_tool_centre(const Statement& statement, MachineState& state, Assumptions& assumed);
/// Throws InputError at rotary words, and at an arc's centre, while I, J and K are the tool's axis.
void check_tool_vector(const Statement& statement, const MachineState& state, bool on_arc);
/// LinuxCNC's M428 (kinematics: places are the tip's) and M429 (identity: they are joints).
void switch_kinematics(const Statement& statement, MachineState& state);
/// G68.2 X Y Z I J K, a tilted working plane by Euler's angles about Z, X and Z again as they go
/// along, and G69, its end.
void set_working_plane(const Statement& statement, MachineState& state, Assumptions& assumed);
/// G254 and G255: Haas's dynamic work offset.
void set_dynamic_offset(const Statement& statement, MachineState& state);
/// Where G53.1 turns the axes: the tool along Z of the tilted plane. Throws InputError where the
/// machine cannot.
RotaryAngles plane_angles(const Statement& statement, const MachineState& state,
                          Assumptions& assumed);

/// Throws InputError at what would move the frame that a working plane or a dynamic offset hangs
/// on, and at rotary words of codes that set offsets.
void check_frame_is_free(const Statement& statement, const Word& word, const MachineState& state);
/// The length that turning a head needs. Throws InputError where nothing states it.
void require_length(const Statement& statement, const Word& word, const MachineState& state);

}  // namespace limitgauge::model::gcode
