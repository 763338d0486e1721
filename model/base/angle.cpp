#include "model/base/angle.h"

#include <cmath>

namespace limitgauge::model {

Vec2 direction(double angle_deg) {
  const double reduced = std::remainder(angle_deg, 360.0);
  if (reduced == 0) return {1, 0};
  if (reduced == 90) return {0, 1};
  if (reduced == -90) return {0, -1};
  if (std::abs(reduced) == 180) return {-1, 0};
  const double angle = radians(reduced);
  return {std::cos(angle), std::sin(angle)};
}

Vec3 turned(const Vec3& v, double angle_deg) {
  if (angle_deg == 0) return v;
  const auto [c, s] = direction(angle_deg);
  return {c * v.x - s * v.y, s * v.x + c * v.y, v.z};
}

}  // namespace limitgauge::model
