#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "model/base/tolerance.h"
#include "model/mesh/triangle_mesh.h"

namespace limitgauge::model {

/// Why a mesh bounds no solid.
struct MeshDefect {
  std::optional<std::size_t> triangle;  ///< where it shows, 0-based; none: the mesh as a whole
  std::string wrong, expected;
};

/// The first defect of a mesh that is to bound a solid, none if it does. Such a mesh has triangles
/// of vertices that exist, are finite and within kFarthestCoordinate_mm; every edge is passed as
/// often one way as the other (closed and oriented; more than two triangles may meet at an edge, as
/// where two solids touch); each connected shell encloses a volume, and one that encloses a
/// negative volume (a cavity) lies in one that does not (mesh_shells.h).
std::optional<MeshDefect> find_defect(const TriangleMesh& mesh);

}  // namespace limitgauge::model
