#pragma once

#include <algorithm>

#include "model/geometry/vec2.h"
#include "model/geometry/vec3.h"

namespace limitgauge::model {

/// The share of `along` at which it comes nearest to `to`, from 0 to 1; 0 where it has no length.
template <class Vec>
constexpr double nearest_share(const Vec& to, const Vec& along) {
  const double squared = length_squared(along);
  return squared > 0 ? std::clamp(dot(to, along) / squared, 0.0, 1.0) : 0.0;
}

/// The way to `p` from the nearest point of the segment from `a` to `b`; Vec is Vec2 or Vec3. A
/// segment without length is its one point. Good to a few units in the last place of the
/// coordinates.
template <class Vec>
constexpr Vec from_segment(const Vec& p, const Vec& a, const Vec& b) {
  const Vec along = b - a, from_a = p - a;
  return from_a - along * nearest_share(from_a, along);
}

template <class Vec>
double distance_to_segment(const Vec& p, const Vec& a, const Vec& b) {
  return length(from_segment(p, a, b));
}
template <class Vec>
constexpr double squared_distance_to_segment(const Vec& p, const Vec& a, const Vec& b) {
  return length_squared(from_segment(p, a, b));
}

}  // namespace limitgauge::model
