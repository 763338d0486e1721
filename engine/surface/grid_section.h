#pragma once

#include <cstdint>
#include <vector>

#include "engine/model/vec3.h"

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

  /// A point in the plane counts as above it: no vertex is ever met exactly.
  bool above(const Vec3& p) const { return p[axis] >= value; }
};

/// Where a chain of a section leaves its grid: side 0 to 3 (v = 0, u = last, v = last, u = 0) and
/// the segment of that side counted along +u or +v.
struct SectionEnd {
  int side = 0;
  int segment = 0;
};

/// One curve of a section within a grid: of line type from side to side, or of ring type (closed;
/// the first point is not repeated).
struct SectionChain {
  std::vector<Vec3> points;
  bool closed = false;
  SectionEnd first, last;  ///< of an open chain
};

/// Scratch memory of one thread.
struct SectionScratch {
  std::vector<std::uint8_t> pending;  ///< one a triangle
  std::vector<int> triangles;
};

/// A grid and a quadtree of coordinate ranges along one axis: the paper's section 5 for one patch.
class GridSection {
 public:
  GridSection(Grid grid, int axis);

  const Grid& grid() const { return grid_; }
  double low() const { return levels_.back().front().low; }
  double high() const { return levels_.back().front().high; }
  /// Appends the curves of the section at `value`: first those of line type, then rings.
  void cut(double value, SectionScratch& scratch, std::vector<SectionChain>& chains) const;

 private:
  struct Range {
    double low = 0, high = 0;
  };
  struct LevelShape {
    int columns = 0, rows = 0;
  };
  void build_leaves();
  void build_upper_levels();
  void search(double value, int level, int column, int row, SectionScratch& scratch) const;
  void collect_leaf(const AxisPlane& plane, int column, int row, SectionScratch& scratch) const;

  Grid grid_;
  int axis_;
  std::vector<std::vector<Range>> levels_;  ///< leaves first
  std::vector<LevelShape> shapes_;
};

}  // namespace limitgauge::engine::surface
