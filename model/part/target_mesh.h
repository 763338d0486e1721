#pragma once

#include <filesystem>
#include <string>

#include "model/mesh/mesh_soup.h"
#include "model/part/cage.h"

namespace limitgauge::model {

/// The cage whose limit surface is the mesh itself: a face a triangle, in the mesh's order, every
/// inner edge and every vertex infinitely sharp. Its name is empty.
Cage faceted_cage(const TriangleMesh& mesh);

/// A mesh as a design: the side from which the corners of its triangles go round counter-clockwise
/// is the one that is machined.
struct TargetMesh {
  TriangleMesh mesh;
  Cage cage;                          ///< faceted_cage of it
  std::vector<std::size_t> numbers;   ///< of its triangles in the file, from 0
  std::size_t dropped_triangles = 0;  ///< two of whose corners are one point
};

/// A mesh of STL, PLY or OBJ as read_mesh_file reads it, but one that need not be closed. Throws
/// InputError, with the triangle's number and place, where the mesh is no two-manifold or not
/// oriented alike, where a triangle has no area (its normal is unknown), where two triangles lie
/// back on each other, where a closed mesh is inside out, and for coordinates too far out.
TargetMesh read_target_mesh(const std::filesystem::path& path);
TargetMesh target_mesh(const TriangleSoup& soup);

/// Whether a mesh, once it is read, has an edge that only one triangle has.
bool is_open(const Cage& faceted);

}  // namespace limitgauge::model
