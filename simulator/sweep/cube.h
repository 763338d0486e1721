#pragma once

#include <cmath>

#include "model/geometry/vec3.h"

namespace limitgauge::simulator {

/// A cube of places, by its middle and half an edge.
struct Cube {
  model::Vec3 middle;
  double half_edge_mm = 0;

  double half_diagonal() const { return std::sqrt(3.0) * half_edge_mm; }
  bool contains(const model::Vec3& p) const {
    return std::abs(p.x - middle.x) <= half_edge_mm && std::abs(p.y - middle.y) <= half_edge_mm &&
           std::abs(p.z - middle.z) <= half_edge_mm;
  }
};

}  // namespace limitgauge::simulator
