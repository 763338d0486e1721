#pragma once

#include <cstdint>
#include <vector>

#include "engine/strategy/locations/cutter_shape.h"
#include "engine/surface/section/section_chain.h"

namespace limitgauge::engine::strategy {

using model::Box3;
using model::Vec3;

/// A box around triangles and a plane z + gx x + gy y = c above them all. The body whose tip is at
/// (x, y, z) clears the plane, and so the triangles, once it is lifted by
/// plane_lift - gx x - gy y - z; then it touches the plane at (contact_x, contact_y) from its axis.
/// Floats are rounded outwards where that matters.
struct LocationNode {
  float low_x = 0, low_y = 0, high_x = 0, high_y = 0, high_z = 0;
  float gx = 0, gy = 0;
  float contact_x = 0, contact_y = 0;
  std::int32_t first = 0;     ///< first of the children, or index of the leaf
  std::int32_t children = 0;  ///< none: a leaf
  double c = 0, plane_lift = 0;
};

/// Cells [u, u_end) x [v, v_end) of a grid.
struct LocationLeaf {
  std::int32_t grid = 0, u = 0, v = 0, u_end = 0, v_end = 0;
};

/// Nodes over the triangles of grids: quadtrees over the cells of each grid, and a tree of median
/// splits over the grids. The root is node 0; children follow each other.
class LocationTree {
 public:
  /// `shape` is the body for which planes are set.
  LocationTree(std::vector<surface::Grid> grids, const CutterShape& shape);

  bool empty() const { return nodes_.empty(); }
  const std::vector<LocationNode>& nodes() const { return nodes_; }
  const LocationLeaf& leaf(const LocationNode& node) const { return leaves_[node.first]; }
  const surface::Grid& grid(int g) const { return grids_[g]; }
  /// Of all triangles; empty where there are none.
  const Box3& box() const { return box_; }

 private:
  friend class LocationTreeBuilder;
  std::vector<surface::Grid> grids_;
  std::vector<LocationNode> nodes_;
  std::vector<LocationLeaf> leaves_;
  Box3 box_;
};

}  // namespace limitgauge::engine::strategy
