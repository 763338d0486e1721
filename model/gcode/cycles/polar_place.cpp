#include "model/gcode/cycles/polar_place.h"

#include <cmath>

#include "model/base/angle.h"
#include "model/base/coordinate_limit.h"

namespace limitgauge::model::gcode {

PolarPlace polar_of(const Statement& statement, double unit_mm, bool incremental) {
  PolarPlace polar;
  polar.incremental = incremental;
  if (const Word* const distance = statement.word('@'))
    polar.distance_mm = distance->value * unit_mm;
  if (const Word* const angle = statement.word('^')) polar.angle_rad = radians(angle->value);
  return polar;
}

Vec2 polar_end(const Statement& statement, const PolarPlace& polar, const Vec2& at_mm) {
  const Word& word = *statement.first_of({'@', '^'});
  const bool turns_on = polar.incremental || !polar.angle_rad;
  if (turns_on && at_mm[0] == 0 && at_mm[1] == 0)
    statement.fail(word, "a polar coordinate from the origin, where no angle is", "@ and ^ in G90");
  double distance_mm = std::hypot(at_mm[0], at_mm[1]);
  if (polar.distance_mm) distance_mm = *polar.distance_mm + (polar.incremental ? distance_mm : 0);
  if (!(std::abs(distance_mm) <= kLargestCoordinateMm))
    statement.fail(word, "a position beyond any machine", "at most 1e9 mm");
  const double angle =
      polar.angle_rad.value_or(0) + (turns_on ? std::atan2(at_mm[1], at_mm[0]) : 0);
  return {distance_mm * std::cos(angle), distance_mm * std::sin(angle)};
}

}  // namespace limitgauge::model::gcode
