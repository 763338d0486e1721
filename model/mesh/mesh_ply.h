#pragma once

#include <bit>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/mesh/mesh_soup.h"

namespace limitgauge::model {

enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };
std::size_t bytes_of(PlyType type);

struct PlyProperty {
  std::string name;
  PlyType type = PlyType::float32;
  std::optional<PlyType> list_count;  ///< of a list: the type of its length
};

struct PlyElement {
  std::string name;
  std::size_t count = 0;
  int line = 0;
  std::vector<PlyProperty> properties;
};

/// The header of a PLY file.
struct PlyHeader {
  std::optional<std::endian> order;  ///< none: ASCII
  std::vector<PlyElement> elements;
  std::size_t bytes = 0;  ///< where the body begins
  int lines = 0;          ///< of the header
};

/// Throws InputError with line and column.
PlyHeader read_ply_header(std::string_view bytes, const std::string& name);

/// The mesh of a PLY file, ASCII or binary of either byte order: x, y, z of the element `vertex`,
/// the list `vertex_indices` or `vertex_index` of the element `face` (polygons as mesh_polygon.h
/// has them); all other elements and properties are passed over. Throws InputError with line and
/// column, in a binary body with the byte; nothing is allocated by a count that the file's size
/// does not bear out.
TriangleSoup read_mesh_ply(std::string_view bytes, const std::string& name);

}  // namespace limitgauge::model
