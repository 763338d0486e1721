#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "engine/model/vec3.h"

namespace limitgauge::model {

/// A triangle mesh, positions in mm; the vertices of a triangle go around it counter-clockwise when
/// seen from outside.
struct TriangleMesh {
  std::vector<Vec3> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

}  // namespace limitgauge::model
