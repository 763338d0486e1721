#include "engine/surface/section/grid_section.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "engine/surface/section/start_search.h"
#include "engine/surface/section/triangle_march.h"

namespace limitgauge::engine::surface {
namespace {

int ceil_div(int a, int b) {
  return (a + b - 1) / b;
}

}  // namespace

GridSection::GridSection(Grid grid, int axis) : grid_(std::move(grid)), axis_(axis) {
  build_leaves();
  build_upper_levels();
}

/// Equal neighbours are told apart by their index, so that a plateau has an extreme point too.
bool GridSection::is_extreme(int u, int v) const {
  if (u == 0 || v == 0 || u == grid_.columns - 1 || v == grid_.rows - 1) return false;
  const double Vec3::*x = coordinate_of(axis_);
  const int n = grid_.columns, i = v * n + u;
  const auto higher = [&](int j) {
    const double xi = grid_.points[i].*x, xj = grid_.points[j].*x;
    return xj > xi || (xj == xi && j > i);
  };
  const bool first = higher(i - 1);
  return higher(i + 1) == first && higher(i - n) == first && higher(i + n) == first &&
         higher(i - n - 1) == first && higher(i + n + 1) == first;
}

GridSection::Node GridSection::leaf(int column, int row) const {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Node node{kInfinity, -kInfinity, false};
  const int last_u = std::min((column + 1) * StartSearch::kLeafCells, grid_.columns - 1);
  const int last_v = std::min((row + 1) * StartSearch::kLeafCells, grid_.rows - 1);
  for (int v = row * StartSearch::kLeafCells; v <= last_v; ++v)
    for (int u = column * StartSearch::kLeafCells; u <= last_u; ++u) {
      const double x = grid_.at(u, v)[axis_];
      node.low = std::min(node.low, x);
      node.high = std::max(node.high, x);
      node.extreme = node.extreme || is_extreme(u, v);
    }
  return node;
}

void GridSection::build_leaves() {
  const LevelShape shape{ceil_div(grid_.columns - 1, StartSearch::kLeafCells),
                         ceil_div(grid_.rows - 1, StartSearch::kLeafCells)};
  std::vector<Node> leaves;
  leaves.reserve(static_cast<std::size_t>(shape.columns) * static_cast<std::size_t>(shape.rows));
  for (int row = 0; row < shape.rows; ++row)
    for (int column = 0; column < shape.columns; ++column) leaves.push_back(leaf(column, row));
  levels_.push_back(std::move(leaves));
  shapes_.push_back(shape);
}

void GridSection::build_upper_levels() {
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

SectionStarts GridSection::starts(std::span<const double> values) const {
  return StartSearch(*this, values).run();
}

void GridSection::trace(const SectionStarts& starts, std::size_t plane, double value,
                        SectionScratch& scratch, std::vector<SectionChain>& chains) const {
  const TriangleMarch walk(grid_, {axis_, value});
  const int first_ring = starts.ring_offsets[plane], last_ring = starts.ring_offsets[plane + 1];
  // Only where rings are looked for it matters which curves are known.
  SectionScratch* visited = first_ring < last_ring ? &scratch : nullptr;
  const std::size_t total = 2 * grid_.points.size();
  if (visited && scratch.visited.size() < total) scratch.visited.resize(total, 0);
  for (int i = starts.line_offsets[plane]; i < starts.line_offsets[plane + 1]; ++i) {
    chains.emplace_back();
    chains.back().first = side_of(starts.lines[i]);
    chains.back().points.reserve(scratch.points + scratch.points / 16);
    walk.follow(starts.lines[i], chains.back(), visited);
    scratch.points = chains.back().points.size();
  }
  for (int i = first_ring; i < last_ring; ++i) {
    if (scratch.visited[triangle_of(starts.rings[i], grid_.columns)]) continue;
    chains.emplace_back();
    walk.follow(starts.rings[i], chains.back(), visited);
  }
  for (const int t : scratch.triangles) scratch.visited[t] = 0;
  scratch.triangles.clear();
}

void GridSection::cut(double value, SectionScratch& scratch,
                      std::vector<SectionChain>& chains) const {
  if (low() >= value || high() < value) return;
  trace(starts({&value, 1}), 0, value, scratch, chains);
}

}  // namespace limitgauge::engine::surface
