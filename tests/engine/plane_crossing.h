#pragma once
// What a plane leaves of a grid's triangles, by brute force.

#include <vector>

#include "engine/surface/section/section_chain.h"

namespace limitgauge::test {

/// Brute force over all triangles: how many the plane crosses and the length of what it leaves.
struct Crossed {
  int triangles = 0;
  double length = 0;
};
inline Crossed crossed(const engine::surface::Grid& grid, const engine::surface::AxisPlane& plane) {
  Crossed sum;
  const auto add = [&](const model::Vec3& a, const model::Vec3& b, const model::Vec3& c) {
    std::vector<model::Vec3> ends;
    const model::Vec3* corner[] = {&a, &b, &c};
    for (int k = 0; k < 3; ++k) {
      const model::Vec3 &p = *corner[k], &q = *corner[(k + 1) % 3];
      if (plane.above(p) == plane.above(q)) continue;
      ends.push_back(lerp(p, q, (plane.value - p[plane.axis]) / (q[plane.axis] - p[plane.axis])));
    }
    if (ends.size() != 2) return;
    ++sum.triangles;
    sum.length += distance(ends[0], ends[1]);
  };
  for (int v = 0; v + 1 < grid.rows; ++v)
    for (int u = 0; u + 1 < grid.columns; ++u) {
      add(grid.at(u, v), grid.at(u + 1, v), grid.at(u + 1, v + 1));
      add(grid.at(u, v), grid.at(u + 1, v + 1), grid.at(u, v + 1));
    }
  return sum;
}

}  // namespace limitgauge::test
