#pragma once

#include <cstdint>
#include <ostream>

#include "model/gcode/program.h"
#include "model/gcode/turning/rotary_path.h"
#include "model/machine/control.h"

namespace limitgauge::model {

/// Whether programs with the tip under control can be written for `control`: fanuc (G43.4), haas
/// (G234) and linuxcnc (M428).
bool has_tip_control(Control control);
/// The dialect that such programs are written in: linuxcnc's own, fanuc's for the others.
Dialect dialect_for(Control control);

/// How a path for a machine with rotary axes is written.
struct TurningWriter {
  WriterOptions text;  ///< dialect_for(control); its arcs are not made use of
  Control control = Control::fanuc;
  const Kinematics& machine;
};

/// Writes `path` as G-code: the axes go to 0, the tool's length comes on and the tip goes to the
/// start's height and then over the start; then the tip is under control, places and angles are
/// named, and the control's own words end it. Feed rates are rounded where the dialect's are.
/// Returns the line of the first place behind the start. Throws std::invalid_argument before
/// anything is written for what the dialect cannot express and
/// for a control without such words; ResourceError where `out` fails.
std::uint32_t write_turning_program(const RotaryPath& path, const TurningWriter& writer,
                                    std::ostream& out);

}  // namespace limitgauge::model
