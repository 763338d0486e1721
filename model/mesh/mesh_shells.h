#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "model/geometry/vec3.h"
#include "model/mesh/triangle_mesh.h"

namespace limitgauge::model {

/// Triangles of a mesh that hang together by their vertices.
struct Shell {
  std::size_t first_triangle = 0;
  Box3 box;
  double volume_mm3 = 0;  ///< enclosed by a closed one; negative where it is inside out

  /// More than rounding makes of one that lies flat.
  bool encloses_volume() const;
};

struct MeshShells {
  std::vector<Shell> shells;               ///< in the order of their first triangles
  std::vector<std::uint32_t> of_triangle;  ///< each triangle's
};
/// The shells of a mesh whose triangles name vertices that exist.
MeshShells shells_of(const TriangleMesh& mesh);

/// The first closed shell that is inside out and no cavity: that lies in none that is not. Whether
/// it does is asked of places of it by rays. Open shells have no inside; none where all are well.
std::optional<std::uint32_t> inside_out_shell(const TriangleMesh& mesh, const MeshShells& of);

}  // namespace limitgauge::model
