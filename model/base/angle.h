#pragma once

#include <numbers>

#include "model/geometry/vec2.h"
#include "model/geometry/vec3.h"

namespace limitgauge::model {

constexpr double radians(double degrees) {
  return degrees * std::numbers::pi / 180;
}

/// Cosine and sine, exact at quarter turns where std::cos would leave 6e-17.
Vec2 direction(double angle_deg);

/// `v` turned about Z, counter-clockwise seen from above; exact at quarter turns.
Vec3 turned(const Vec3& v, double angle_deg);

}  // namespace limitgauge::model
