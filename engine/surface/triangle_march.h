#pragma once

#include <optional>

#include "engine/surface/grid_section.h"

namespace limitgauge::engine::surface {

/// A mesh edge of a grid: from point (u, v) to its right, upper or diagonal neighbour.
struct GridEdge {
  enum class Kind { right, up, diagonal };
  Kind kind = Kind::right;
  int u = 0, v = 0;
  friend bool operator==(const GridEdge&, const GridEdge&) = default;
};

/// Walks a plane's curve from triangle to triangle (paper section 5.3). Since no vertex counts as
/// lying in the plane, a triangle has two crossed edges or none, and the eight cases of the quad
/// come down to one.
class TriangleMarch {
 public:
  TriangleMarch(const Grid& grid, const AxisPlane& plane) : grid_(grid), plane_(plane) {}

  /// Triangles are numbered 2 (v (columns - 1) + u), plus one for the upper left one.
  bool crosses(int triangle) const;
  /// The crossed edge of `triangle` on a side of the grid, where it has one.
  std::optional<GridEdge> side_edge(int triangle) const;
  GridEdge any_edge(int triangle) const;
  /// The other crossed edge of `triangle`.
  GridEdge exit(int triangle, const GridEdge& entry) const;
  /// The triangle across `edge`, or nothing at a side of the grid.
  std::optional<int> across(int triangle, const GridEdge& edge) const;
  Vec3 point(const GridEdge& edge) const;
  SectionEnd end(const GridEdge& edge) const;

 private:
  bool crossed(const GridEdge& edge) const;
  bool on_side(const GridEdge& edge) const;
  const Vec3& from(const GridEdge& e) const { return grid_.at(e.u, e.v); }
  const Vec3& to(const GridEdge& e) const;

  const Grid& grid_;
  AxisPlane plane_;
};

}  // namespace limitgauge::engine::surface
