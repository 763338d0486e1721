#pragma once

#include <vector>

#include "model/geometry/vec3.h"

namespace limitgauge::engine::surface {

using model::Vec3;

/// Index of point `t` of `side` of a square grid with `cells` cells a side, row by row; sides run
/// counter-clockwise from corner to corner.
inline int side_index(int side, int t, int cells) {
  const int row = cells + 1;
  switch (side) {
    case 0:
      return t;
    case 1:
      return t * row + cells;
    case 2:
      return cells * row + cells - t;
    default:
      return (cells - t) * row;
  }
}

/// The limit mesh of one patch (paper section 4): (2^depth + 1)² limit points and unit normals, row
/// by row; u runs along the patch's first edge, v along its fourth, seen counter-clockwise.
struct LimitPatch {
  int depth = 0;
  std::vector<Vec3> points;
  std::vector<Vec3> normals;

  int cells() const { return 1 << depth; }
  int index(int u, int v) const { return v * (cells() + 1) + u; }
  int side_index(int side, int t) const { return surface::side_index(side, t, cells()); }
};

}  // namespace limitgauge::engine::surface
