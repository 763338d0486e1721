#pragma once

#include <string>
#include <string_view>

#include "model/mesh/mesh_soup.h"

namespace limitgauge::model {

/// The mesh of a Wavefront OBJ: `v` and `f` (1-based or negative indices, `v/vt/vn` forms; polygons
/// as mesh_polygon.h has them). Names, groups, materials, normals, texture coordinates, lines and
/// points bound no solid and are passed over; any other statement is an InputError with line and
/// column.
TriangleSoup read_mesh_obj(std::string_view text, const std::string& name);

}  // namespace limitgauge::model
