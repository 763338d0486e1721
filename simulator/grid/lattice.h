#pragma once

#include <array>
#include <cmath>

#include "model/geometry/vec3.h"

namespace limitgauge::simulator {

using Index3 = std::array<int, 3>;

/// Where the voxels are: the centre of voxel (i, j, k) is origin + voxel · (i, j, k), in mm.
struct Lattice {
  model::Vec3 origin_mm;
  double voxel_mm = 1;

  model::Vec3 point(const Index3& i) const {
    return origin_mm + model::Vec3{1.0 * i[0], 1.0 * i[1], 1.0 * i[2]} * voxel_mm;
  }
  /// Middle of a cube of `size` voxels an edge whose lowest voxel is `corner`.
  model::Vec3 middle(const Index3& corner, int size) const {
    const double h = 0.5 * (size - 1);
    return origin_mm + model::Vec3{corner[0] + h, corner[1] + h, corner[2] + h} * voxel_mm;
  }
  /// Half the edge of the cube that the voxels' centres span.
  double half_edge(int size) const { return 0.5 * (size - 1) * voxel_mm; }
  double half_diagonal(int size) const { return std::sqrt(3.0) * half_edge(size); }
};

}  // namespace limitgauge::simulator
