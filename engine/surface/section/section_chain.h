#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "model/geometry/vec3.h"

/// A grid of points, the planes that cut it, and the curves that they leave in it.
namespace limitgauge::engine::surface {

using model::Box3;
using model::Vec3;

/// A grid of points, row by row; every cell is two triangles, split from its first corner to the
/// opposite one.
struct Grid {
  int columns = 0, rows = 0;  ///< of points
  std::vector<Vec3> points;

  const Vec3& at(int u, int v) const { return points[v * columns + u]; }
};

/// A plane perpendicular to axis 0, 1 or 2 (X, Y, Z) at `value` mm.
struct AxisPlane {
  int axis = 0;
  double value = 0;

  /// A point in the plane counts as above it: no vertex is ever met exactly. Every section is thus
  /// the one of a plane lower by less than any number: where the surface touches a plane from below
  /// stands a ring of no size, where from above nothing, and a face in the plane gives its outline
  /// towards what lies below.
  bool above(const Vec3& p) const { return p[axis] >= value; }
};

/// A way into a triangle of a grid: through one of its edges in the cell's counter-clockwise order.
/// Cell (u, v) has the corners a = (u, v), b = (u + 1, v), c = (u + 1, v + 1), d = (u, v + 1) and
/// the triangles abc and acd.
struct GridEntry {
  enum class Edge : std::uint8_t { ab, bc, ca, ac, cd, da };
  int u = 0, v = 0;
  Edge edge = Edge::ab;
  friend bool operator==(const GridEntry&, const GridEntry&) = default;
};

/// Where a chain of a section leaves its grid: side 0 to 3 (v = 0, u = last, v = last, u = 0) and
/// the segment of that side counted along +u or +v.
struct SectionEnd {
  int side = 0;
  int segment = 0;
};

/// One curve of a section within a grid: of line type from side to side, or of ring type (closed;
/// the first point is not repeated). What is above the plane lies on the left, seen from the side
/// from which u turns counter-clockwise into v.
struct SectionChain {
  std::vector<Vec3> points;
  bool closed = false;
  SectionEnd first, last;  ///< of an open chain
};

/// Where the curves of a family of planes begin in one grid, plane by plane: every curve of line
/// type once; every ring at least once, among places on other curves.
struct SectionStarts {
  std::vector<int> line_offsets, ring_offsets;  ///< planes + 1 each
  std::vector<GridEntry> lines, rings;

  bool empty() const { return lines.empty() && rings.empty(); }
};

/// Scratch memory of one thread.
struct SectionScratch {
  std::vector<std::uint8_t> visited;  ///< one a triangle
  std::vector<int> triangles;         ///< those visited
  std::size_t points = 0;             ///< of the chain before: the next is much like it
};

}  // namespace limitgauge::engine::surface
