#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "model/base/tolerance.h"
#include "model/mesh/mesh_soup.h"

namespace limitgauge::model {

/// A polygon as a fan of triangles, or why it has none.
struct PolygonFan {
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::string wrong;  ///< empty where there is a fan
};

/// A fan about the first corner that gives one: all its triangles face the way that the polygon
/// does. Always so for convex polygons; others must be seen whole from one of their corners.
/// `corners` are three or more indices into `vertices`. A triangle is its own fan.
PolygonFan fan_of(std::span<const std::uint32_t> corners, const std::vector<Vec3>& vertices);

/// What a mesh file of polygons says.
struct PolygonSoup {
  std::vector<Vec3> vertices;
  std::vector<std::uint32_t> corners;  ///< of all polygons one after the other
  std::vector<std::uint64_t> ends;     ///< of each polygon in `corners`
  std::vector<std::uint64_t> places;   ///< of each polygon, as TriangleSoup has them
  bool binary = false;
  std::string file;  ///< in errors
};

/// Every polygon as its fan. Throws InputError at the polygon's place where a corner names no
/// vertex or there is no fan, and for no polygons at all.
TriangleSoup fanned(PolygonSoup soup);

}  // namespace limitgauge::model
