#include "model/gcode/turning/turning_path.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "model/base/error.h"
#include "model/gcode/turning/turning_path_maker.h"

namespace limitgauge::model {
namespace {

void require_turning_options(const PathOptions& options) {
  if (!(std::isfinite(options.chord_error_mm) && options.chord_error_mm > 0))
    throw std::invalid_argument("chord error must be greater than 0");
  if (!(std::isfinite(options.reach_mm) && options.reach_mm >= 0))
    throw std::invalid_argument("a tool's reach is finite and not negative");
  if (options.first == 0 && !options.start_mm)
    throw std::invalid_argument("a path that turns its tool begins at a stated start");
}

/// CL data name the tool's axis with each place.
TurningPath stated_path(const Program& program, const PathOptions& options) {
  const std::size_t last = std::min(options.last, program.motions.size());
  const std::size_t first = std::min(options.first, last);
  PathOptions upright = options;
  upright.kinematics.reset();
  TurningPath out{tip_path(program, upright), {}};
  const RigidPlacement turn{options.machine_in_part.rotate_z_deg, {}};
  out.axes.start = turn(axis_from(*program.axes, first));
  for (std::size_t i = first; i < last; ++i) out.axes.to.push_back(turn(program.axes->to[i]));
  return out;
}

}  // namespace

TurningPath to_turning_path(const Program& program, const PathOptions& options) {
  require_turning_options(options);
  TurningPath made =
      program.axes ? stated_path(program, options) : TurningPathMaker(program, options).make();
  require_axes(made.path, made.axes);
  return made;
}

double reach_mm(const Cutter& cutter) {
  double height_mm = cutter.flute_length_mm;
  double farthest_mm = std::hypot(largest_radius_mm(cutter), height_mm);
  for (const auto* parts : {&cutter.shank, &cutter.holder}) {
    for (const CylinderPart& part : *parts) {
      height_mm += part.length_mm;
      farthest_mm = std::max(farthest_mm, std::hypot(part.diameter_mm / 2, height_mm));
    }
  }
  return farthest_mm;
}

bool cuts_while_turning(const Program& program, const Kinematics& machine, std::size_t first,
                        std::size_t last) {
  return std::any_of(program.turns.begin(), program.turns.end(), [&](const AxisTurn& turn) {
    if (turn.motion < first || turn.motion >= last || turn.rapid || turn.parked) return false;
    return program.motions[turn.motion].kind == MotionKind::arc ||
           turn.turn.tip_speed_mm(machine) > 0;
  });
}

}  // namespace limitgauge::model
