#include "model/gcode/cycles/cutter_compensation_plane.h"

#include <numbers>

#include "model/base/number_text.h"

namespace limitgauge::model::gcode {

double sweep_of(PlaneVector from, PlaneVector to, PlaneVector centre, double turns) {
  const PlaneVector start = from - centre, end = to - centre;
  const double full = 2 * std::numbers::pi;
  double sweep = std::atan2(end.b, end.a) - std::atan2(start.b, start.a);
  if (turns > 0) return (sweep <= 0 ? sweep + full : sweep) + (turns - 1) * full;
  if (sweep >= 0) sweep -= full;
  return sweep + (turns + 1) * full;
}

}  // namespace limitgauge::model::gcode
