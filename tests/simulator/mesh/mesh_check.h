#pragma once

#include <cstddef>

#include "model/mesh/triangle_mesh.h"

namespace limitgauge::simulator::test {

/// What keeps a mesh from being a closed manifold turned one way, counted from its indices alone.
struct MeshFaults {
  std::size_t edges = 0;   ///< directed edges that are not met once, or whose reverse is not
  std::size_t fans = 0;    ///< vertices whose triangles do not make one closed fan
  std::size_t unused = 0;  ///< vertices of no triangle
  bool none() const { return edges == 0 && fans == 0 && unused == 0; }
};
MeshFaults faults(const model::TriangleMesh& mesh);

double enclosed_volume(const model::TriangleMesh& mesh);

}  // namespace limitgauge::simulator::test
