#pragma once

#include <algorithm>
#include <cmath>

#include "model/geometry/vec2.h"
#include "model/geometry/vec3.h"

namespace limitgauge::engine::surface {

using model::Vec2;
using model::Vec3;

/// The linear map T of the plane across a normal; what stands along the normal is dropped.
class LevelMap {
 public:
  LevelMap() = default;
  /// Takes `to_x` and `to_y`, seen along the normal, to the unit vectors.
  LevelMap(const Vec3& normal, const Vec3& to_x, const Vec3& to_y) {
    const double area = dot(normal, cross(to_x, to_y));
    x_ = cross(to_y, normal) / area;
    y_ = cross(normal, to_x) / area;
  }
  Vec2 operator()(const Vec3& v) const { return {dot(x_, v), dot(y_, v)}; }
  double length(const Vec3& v) const { return std::hypot(dot(x_, v), dot(y_, v)); }
  /// At least |T|.
  double norm() const { return std::hypot(model::length(x_), model::length(y_)); }

 private:
  Vec3 x_, y_;
};

/// The longest of many vectors of the plane: one root for all of them.
class Longest {
 public:
  void see(const Vec2& v) {
    const double squared = v.x * v.x + v.y * v.y;
    if (squared > squared_) squared_ = squared, longest_ = v;
  }
  double length() const { return std::hypot(longest_.x, longest_.y); }

 private:
  Vec2 longest_{};
  double squared_ = 0;
};

/// Largest factor by which a linear map of the plane stretches, from the images of the unit
/// vectors.
inline double stretch(const Vec2& a, const Vec2& b) {
  const double sum = a.x * a.x + a.y * a.y + b.x * b.x + b.y * b.y;
  const double area = cross(a, b);
  return std::sqrt((sum + std::sqrt(std::max(0.0, sum * sum - 4 * area * area))) / 2);
}

}  // namespace limitgauge::engine::surface
