#pragma once

#include <array>
#include <cmath>

#include "engine/model/vec3.h"

namespace limitgauge::engine::surface {

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
  std::array<double, 2> operator()(const Vec3& v) const { return {dot(x_, v), dot(y_, v)}; }
  double length(const Vec3& v) const { return std::hypot(dot(x_, v), dot(y_, v)); }
  /// At least |T|.
  double norm() const { return std::hypot(model::length(x_), model::length(y_)); }

 private:
  Vec3 x_, y_;
};

}  // namespace limitgauge::engine::surface
