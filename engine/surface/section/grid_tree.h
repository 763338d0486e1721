#pragma once

#include <vector>

#include "engine/surface/section/section_chain.h"

namespace limitgauge::engine::surface {

/// A quadtree of coordinate ranges over the cells of a grid, along one axis.
class GridTree {
 public:
  /// Cells along a side of a leaf.
  static constexpr int kLeafCells = 8;

  struct Node {
    double low = 0, high = 0;
    bool extreme = false;  ///< holds a point that is higher or lower than all its neighbours
  };
  struct LevelShape {
    int columns = 0, rows = 0;
  };

  GridTree(const Grid& grid, int axis);

  const Node& whole() const { return levels_.back().front(); }
  /// Level 0 has the leaves.
  int levels() const { return static_cast<int>(levels_.size()); }
  LevelShape shape(int level) const { return shapes_[level]; }
  const Node& node(int level, int column, int row) const {
    return levels_[level][row * shapes_[level].columns + column];
  }

 private:
  void build_leaves(const Grid& grid, int axis);
  void build_upper_levels();

  std::vector<std::vector<Node>> levels_;  ///< leaves first
  std::vector<LevelShape> shapes_;
};

}  // namespace limitgauge::engine::surface
