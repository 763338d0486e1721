#include "engine/model/angle.h"

#include <cmath>

namespace limitgauge::model {

std::array<double, 2> direction(double angle_deg) {
  const double reduced = std::remainder(angle_deg, 360.0);
  if (reduced == 0) return {1, 0};
  if (reduced == 90) return {0, 1};
  if (reduced == -90) return {0, -1};
  if (std::abs(reduced) == 180) return {-1, 0};
  const double angle = radians(reduced);
  return {std::cos(angle), std::sin(angle)};
}

}  // namespace limitgauge::model
