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

/// A cube as it lies in another frame, where it may lean.
struct HeldCube {
  model::Vec3 middle;
  double half_edge_mm = 0;      ///< of the cube along the axes of that frame that holds it
  double half_diagonal_mm = 0;  ///< its own
};

}  // namespace limitgauge::simulator
