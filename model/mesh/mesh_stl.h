#pragma once

#include <string>
#include <string_view>

#include "model/mesh/mesh_soup.h"

namespace limitgauge::model {

/// Whether the bytes are as long as a binary STL of the number of triangles that they state.
bool has_binary_stl_size(std::string_view bytes);

/// Binary STL: 80 bytes, the number of triangles, 50 bytes each, all little endian. The stated
/// normals and attributes carry nothing and are not looked at. Throws InputError with the byte.
TriangleSoup read_binary_stl(std::string_view bytes, const std::string& name);

/// ASCII STL, one statement a line, keywords in either case, one or more solids. The stated normals
/// are not looked at (writers put NaN there). Throws InputError with line and column.
TriangleSoup read_ascii_stl(std::string_view text, const std::string& name);

}  // namespace limitgauge::model
