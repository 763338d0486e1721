#pragma once

#include <algorithm>

#include "simulator/grid/lattice.h"

namespace limitgauge::simulator {

/// A box of voxels: `low` belongs to it, `high` does not.
struct IndexBox {
  Index3 low{}, high{};

  bool contains(const Index3& i) const {
    for (int a = 0; a < 3; ++a)
      if (i[a] < low[a] || i[a] >= high[a]) return false;
    return true;
  }
  bool contains(const IndexBox& b) const {
    for (int a = 0; a < 3; ++a)
      if (b.low[a] < low[a] || b.high[a] > high[a]) return false;
    return true;
  }
  bool meets(const IndexBox& b) const {
    for (int a = 0; a < 3; ++a)
      if (b.high[a] <= low[a] || b.low[a] >= high[a]) return false;
    return true;
  }
  IndexBox common(const IndexBox& b) const {
    IndexBox c = *this;
    for (int a = 0; a < 3; ++a) {
      c.low[a] = std::max(low[a], b.low[a]);
      c.high[a] = std::max(c.low[a], std::min(high[a], b.high[a]));
    }
    return c;
  }
  IndexBox grown(int by) const {
    IndexBox g = *this;
    for (int a = 0; a < 3; ++a) g.low[a] -= by, g.high[a] += by;
    return g;
  }
  double voxels() const {
    return static_cast<double>(high[0] - low[0]) * (high[1] - low[1]) * (high[2] - low[2]);
  }
};

inline IndexBox cube_at(const Index3& corner, int edge) {
  return {corner, {corner[0] + edge, corner[1] + edge, corner[2] + edge}};
}

/// Calls `visit` for the corners of the cubes of `edge` voxels, aligned to multiples of it, that
/// meet the box; x outermost, z innermost.
template <class Visit>
void each_cube(const IndexBox& box, int edge, Visit visit) {
  const auto aligned = [edge](int i) {
    return i >= 0 ? i / edge * edge : -((-i + edge - 1) / edge) * edge;
  };
  for (int x = aligned(box.low[0]); x < box.high[0]; x += edge)
    for (int y = aligned(box.low[1]); y < box.high[1]; y += edge)
      for (int z = aligned(box.low[2]); z < box.high[2]; z += edge) visit(Index3{x, y, z});
}

}  // namespace limitgauge::simulator
