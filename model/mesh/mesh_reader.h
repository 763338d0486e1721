#pragma once

#include <filesystem>
#include <istream>
#include <string>

#include "model/mesh/mesh_soup.h"

namespace limitgauge::model {

/// Reads a closed mesh from STL (ASCII or binary), OBJ or PLY (ASCII, binary of either byte order);
/// which of them is told by the content, an OBJ by its name too. Units are millimetres. Throws
/// InputError, with line and column or the byte, for whatever is wrong with the file or keeps the
/// mesh from bounding a solid; ResourceError where memory does not do.
MeshReading read_mesh_file(const std::filesystem::path& path);
MeshReading read_mesh(std::istream& in, const std::string& name_in_errors);

/// The triangles as the file has them, of a solid or not; every corner names a vertex. Throws
/// InputError for what is wrong with the file, ResourceError where memory does not do.
TriangleSoup read_mesh_soup(const std::filesystem::path& path);

/// The mesh alone.
TriangleMesh read_triangle_mesh(const std::filesystem::path& path);
TriangleMesh read_triangle_mesh(std::istream& in, const std::string& name_in_errors);

}  // namespace limitgauge::model
