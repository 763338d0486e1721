#pragma once

#include "model/gcode/machine/machine_state.h"
#include "model/gcode/program.h"
#include "model/gcode/read/assumptions.h"
#include "model/gcode/text/statement.h"

namespace limitgauge::model::gcode {

/// Of a block along an axis behind a change of the tool's length or the zero offset, which a
/// control may add to the way: throws InputError where that is in G91
/// (ControlRules::length_moves_z, offsets_move_axes).
void take_due_offsets(const Statement& statement, MachineState& state);

/// Where the axis words lead, in the active work frame; marks the axes that become known by it.
/// Throws InputError for positions out of range, and where a place is needed that nothing states.
Vec3 end_of(const Statement& statement, MachineState& state);

/// The same for the point that G28 and G30 go by: an axis that is already where nothing states may
/// stay there.
Vec3 waypoint_of(const Statement& statement, MachineState& state);

/// G0 and G1, G53 beside them. Moves `state` and gives the motion in the active work frame, its
/// kind, plane, end and feed rate set.
Motion straight_motion(const Statement& statement, MachineState& state, bool rapid,
                       Assumptions& assumed);
/// G2 and G3.
Motion arc_motion(const Statement& statement, MachineState& state, bool counter_clockwise);

/// The way of a motion from `from_mm`, both in one frame: of an arc along it.
double motion_length_mm(const Motion& motion, const Vec3& from_mm);

/// Throws InputError where the active coordinate system is one that nothing states.
void check_system(const Statement& statement, const MachineState& state);

}  // namespace limitgauge::model::gcode
