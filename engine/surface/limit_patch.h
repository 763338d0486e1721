#pragma once

#include <vector>

#include "engine/model/vec3.h"

namespace limitgauge::engine::surface {

using model::Vec3;

/// The limit mesh of one patch (paper section 4): (2^depth + 1)² limit points and unit normals, row
/// by row; u runs along the patch's first edge, v along its fourth, seen counter-clockwise.
struct LimitPatch {
  int depth = 0;
  std::vector<Vec3> points;
  std::vector<Vec3> normals;

  int cells() const { return 1 << depth; }
  int index(int u, int v) const { return v * (cells() + 1) + u; }
};

}  // namespace limitgauge::engine::surface
