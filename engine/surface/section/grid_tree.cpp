#include "engine/surface/section/grid_tree.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "engine/surface/section/triangle_march.h"

namespace limitgauge::engine::surface {
namespace {

int ceil_div(int a, int b) {
  return (a + b - 1) / b;
}

/// Equal neighbours are told apart by their index, so that a plateau has an extreme point too.
bool is_extreme(const Grid& grid, int axis, int u, int v) {
  if (u == 0 || v == 0 || u == grid.columns - 1 || v == grid.rows - 1) return false;
  const double Vec3::*x = coordinate_of(axis);
  const int n = grid.columns, i = v * n + u;
  const auto higher = [&](int j) {
    const double xi = grid.points[i].*x, xj = grid.points[j].*x;
    return xj > xi || (xj == xi && j > i);
  };
  const bool first = higher(i - 1);
  return higher(i + 1) == first && higher(i - n) == first && higher(i + n) == first &&
         higher(i - n - 1) == first && higher(i + n + 1) == first;
}

GridTree::Node leaf(const Grid& grid, int axis, int column, int row) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  GridTree::Node node{kInfinity, -kInfinity, false};
  const int last_u = std::min((column + 1) * GridTree::kLeafCells, grid.columns - 1);
  const int last_v = std::min((row + 1) * GridTree::kLeafCells, grid.rows - 1);
  for (int v = row * GridTree::kLeafCells; v <= last_v; ++v)
    for (int u = column * GridTree::kLeafCells; u <= last_u; ++u) {
      const double x = grid.at(u, v)[axis];
      node.low = std::min(node.low, x);
      node.high = std::max(node.high, x);
      node.extreme = node.extreme || is_extreme(grid, axis, u, v);
    }
  return node;
}

}  // namespace

GridTree::GridTree(const Grid& grid, int axis) {
  build_leaves(grid, axis);
  build_upper_levels();
}

void GridTree::build_leaves(const Grid& grid, int axis) {
  const LevelShape shape{ceil_div(grid.columns - 1, kLeafCells),
                         ceil_div(grid.rows - 1, kLeafCells)};
  std::vector<Node> leaves;
  leaves.reserve(static_cast<std::size_t>(shape.columns) * static_cast<std::size_t>(shape.rows));
  for (int row = 0; row < shape.rows; ++row)
    for (int column = 0; column < shape.columns; ++column)
      leaves.push_back(leaf(grid, axis, column, row));
  levels_.push_back(std::move(leaves));
  shapes_.push_back(shape);
}

void GridTree::build_upper_levels() {
  while (levels_.back().size() > 1) {
    const LevelShape below = shapes_.back();
    const LevelShape shape{ceil_div(below.columns, 2), ceil_div(below.rows, 2)};
    std::vector<Node> nodes;
    for (int row = 0; row < shape.rows; ++row)
      for (int column = 0; column < shape.columns; ++column) {
        Node node = levels_.back()[2 * row * below.columns + 2 * column];
        for (int v = 2 * row; v < std::min(2 * row + 2, below.rows); ++v)
          for (int u = 2 * column; u < std::min(2 * column + 2, below.columns); ++u) {
            const Node& child = levels_.back()[v * below.columns + u];
            node = {std::min(node.low, child.low), std::max(node.high, child.high),
                    node.extreme || child.extreme};
          }
        nodes.push_back(node);
      }
    levels_.push_back(std::move(nodes));
    shapes_.push_back(shape);
  }
}

}  // namespace limitgauge::engine::surface
