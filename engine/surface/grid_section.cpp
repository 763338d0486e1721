#include "engine/surface/grid_section.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "engine/surface/triangle_march.h"

namespace limitgauge::engine::surface {
namespace {

/// Cells along a side of a leaf of the quadtree.
constexpr int kLeafCells = 8;

int ceil_div(int a, int b) {
  return (a + b - 1) / b;
}

/// Follows the curve that enters `triangle` through `entry` until it leaves the grid or closes.
void march(const TriangleMarch& walk, int triangle, GridEdge entry, SectionScratch& scratch,
           SectionChain& chain) {
  for (;;) {
    chain.points.push_back(walk.point(entry));
    scratch.pending[triangle] = 0;
    const GridEdge exit = walk.exit(triangle, entry);
    const auto next = walk.across(triangle, exit);
    if (!next) {
      chain.points.push_back(walk.point(exit));
      chain.last = walk.end(exit);
      return;
    }
    if (!scratch.pending[*next]) return;
    triangle = *next;
    entry = exit;
  }
}

}  // namespace

GridSection::GridSection(Grid grid, int axis) : grid_(std::move(grid)), axis_(axis) {
  build_leaves();
  build_upper_levels();
}

void GridSection::build_leaves() {
  const LevelShape shape{ceil_div(grid_.columns - 1, kLeafCells),
                         ceil_div(grid_.rows - 1, kLeafCells)};
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  std::vector<Range> leaves(
      static_cast<std::size_t>(shape.columns) * static_cast<std::size_t>(shape.rows),
      Range{kInfinity, -kInfinity});
  for (int row = 0; row < shape.rows; ++row)
    for (int column = 0; column < shape.columns; ++column) {
      Range& range = leaves[row * shape.columns + column];
      const int last_u = std::min((column + 1) * kLeafCells, grid_.columns - 1);
      const int last_v = std::min((row + 1) * kLeafCells, grid_.rows - 1);
      for (int v = row * kLeafCells; v <= last_v; ++v)
        for (int u = column * kLeafCells; u <= last_u; ++u) {
          const double x = grid_.at(u, v)[axis_];
          range.low = std::min(range.low, x);
          range.high = std::max(range.high, x);
        }
    }
  levels_.push_back(std::move(leaves));
  shapes_.push_back(shape);
}

void GridSection::build_upper_levels() {
  while (levels_.back().size() > 1) {
    const LevelShape below = shapes_.back();
    const LevelShape shape{ceil_div(below.columns, 2), ceil_div(below.rows, 2)};
    std::vector<Range> ranges;
    for (int row = 0; row < shape.rows; ++row)
      for (int column = 0; column < shape.columns; ++column) {
        Range range = levels_.back()[2 * row * below.columns + 2 * column];
        for (int v = 2 * row; v < std::min(2 * row + 2, below.rows); ++v)
          for (int u = 2 * column; u < std::min(2 * column + 2, below.columns); ++u) {
            const Range& child = levels_.back()[v * below.columns + u];
            range = {std::min(range.low, child.low), std::max(range.high, child.high)};
          }
        ranges.push_back(range);
      }
    levels_.push_back(std::move(ranges));
    shapes_.push_back(shape);
  }
}

void GridSection::search(double value, int level, int column, int row,
                         SectionScratch& scratch) const {
  const LevelShape shape = shapes_[level];
  if (column >= shape.columns || row >= shape.rows) return;
  const Range& range = levels_[level][row * shape.columns + column];
  if (range.low >= value || range.high < value) return;
  if (level == 0) {
    collect_leaf({axis_, value}, column, row, scratch);
    return;
  }
  for (int v = 0; v < 2; ++v)
    for (int u = 0; u < 2; ++u) search(value, level - 1, 2 * column + u, 2 * row + v, scratch);
}

void GridSection::collect_leaf(const AxisPlane& plane, int column, int row,
                               SectionScratch& scratch) const {
  const int last_u = std::min((column + 1) * kLeafCells, grid_.columns - 1);
  const int last_v = std::min((row + 1) * kLeafCells, grid_.rows - 1);
  for (int v = row * kLeafCells; v < last_v; ++v)
    for (int u = column * kLeafCells; u < last_u; ++u) {
      const bool a = plane.above(grid_.at(u, v)), b = plane.above(grid_.at(u + 1, v));
      const bool c = plane.above(grid_.at(u + 1, v + 1)), d = plane.above(grid_.at(u, v + 1));
      const int first = 2 * (v * (grid_.columns - 1) + u);
      if (a != b || a != c) scratch.triangles.push_back(first);
      if (a != c || a != d) scratch.triangles.push_back(first + 1);
    }
}

void GridSection::cut(double value, SectionScratch& scratch,
                      std::vector<SectionChain>& chains) const {
  scratch.triangles.clear();
  search(value, static_cast<int>(levels_.size()) - 1, 0, 0, scratch);
  const auto total = static_cast<std::size_t>(2 * (grid_.columns - 1) * (grid_.rows - 1));
  if (scratch.pending.size() < total) scratch.pending.resize(total, 0);
  for (const int t : scratch.triangles) scratch.pending[t] = 1;
  const TriangleMarch walk(grid_, {axis_, value});
  for (const int t : scratch.triangles) {
    if (!scratch.pending[t]) continue;
    const auto entry = walk.side_edge(t);
    if (!entry) continue;
    chains.emplace_back();
    chains.back().first = walk.end(*entry);
    march(walk, t, *entry, scratch, chains.back());
  }
  for (const int t : scratch.triangles) {
    if (!scratch.pending[t]) continue;
    chains.emplace_back();
    chains.back().closed = true;
    march(walk, t, walk.any_edge(t), scratch, chains.back());
  }
}

}  // namespace limitgauge::engine::surface
