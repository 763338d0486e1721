#pragma once

#include "model/gcode/program_path.h"

namespace limitgauge::model {

/// A path whose tool turns as it goes.
struct TurningPath {
  Toolpath path;
  ToolAxes axes;
};

/// Moves in the part's frame as it lies with all rotary axes at zero, and how the tool stands in
/// it, for motions [first, last) of `program`: CL data that state the tool's axis, or motions of
/// options.kinematics that may turn rotary axes, arcs too. A motion that turns them is cut into
/// moves of straight tip and great-circle axis (TurnBend) so that no place of the tool within
/// options.reach_mm is farther than options.chord_error_mm from where the machine has it; arcs
/// become chords as in to_toolpath, and one that turns chords that turn evenly, each within half
/// of that. The largest error made, both parts of it, is recorded in the path. Feeds of such moves
/// are those of the tip in the part. A tool that parks goes up along the machine's Z, above
/// options.around_mm however the tables stand, and turns there as the machine does.
///
/// Throws std::invalid_argument unless 0 < chord_error_mm < infinity, reach_mm is finite, and a
/// program that is taken from its first motion has a start; ResourceError for more than most_moves
/// moves.
TurningPath to_turning_path(const Program& program, const PathOptions& options);

/// How far the farthest place of the tool, its shank and its holder is from the tip.
double reach_mm(const Cutter& cutter);

/// Whether some motion of [first, last) cuts while it turns rotary axes of `machine`: a feed that
/// moves the tip in the workpiece.
bool cuts_while_turning(const Program& program, const Kinematics& machine, std::size_t first,
                        std::size_t last);

}  // namespace limitgauge::model
