#pragma once

#include <optional>

#include "engine/surface/section/section_chain.h"

namespace limitgauge::engine::surface {

/// Walks a plane's curve from triangle to triangle (paper sections 5.3 and 5.4). Since no vertex
/// counts as lying in the plane, a triangle has two crossed edges or none: the paper's eight cases
/// of the quad come down to three edges of each of its two triangles.
class TriangleMarch {
 public:
  TriangleMarch(const Grid& grid, const AxisPlane& plane);

  /// Appends the curve that comes in through `start`, above the plane on its left, until it leaves
  /// the grid or closes. Triangles gone through are marked in `visited` (2 (v (columns - 1) + u),
  /// plus one for acd) where it is given.
  void follow(const GridEntry& start, SectionChain& chain, SectionScratch* visited) const;

 private:
  void add_crossing(const Vec3& below, const Vec3& above, std::vector<Vec3>& points) const;

  const Grid& grid_;
  AxisPlane plane_;
  double Vec3::*coordinate_;
};

/// Where an entry through a side of the grid lies.
SectionEnd side_of(const GridEntry& entry);

/// Number of the triangle that `entry` leads into.
int triangle_of(const GridEntry& entry, int columns);

/// The coordinate of an axis.
double Vec3::*coordinate_of(int axis);

}  // namespace limitgauge::engine::surface
