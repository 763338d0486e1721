#include "model/gcode/turning/turning_path.h"

#include <algorithm>
#include <cmath>

namespace limitgauge::model {

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
