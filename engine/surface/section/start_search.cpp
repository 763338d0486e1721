#include "engine/surface/section/start_search.h"

#include <algorithm>

#include "engine/surface/section/triangle_march.h"

namespace limitgauge::engine::surface {

using Edge = GridEntry::Edge;

StartSearch::StartSearch(const Grid& grid, int axis, const GridTree& tree,
                         std::span<const double> values)
    : grid_(grid), tree_(tree), coordinate_(coordinate_of(axis)), values_(values) {}

SectionStarts StartSearch::run() {
  for (int side = 0; side < 4; ++side) scan_side(side);
  search(tree_.levels() - 1, 0, 0, {0, static_cast<int>(values_.size())});
  SectionStarts found;
  gather(lines_, found.line_offsets, found.lines);
  gather(rings_, found.ring_offsets, found.rings);
  return found;
}

int StartSearch::count(const Vec3& p) const {
  return static_cast<int>(std::upper_bound(values_.begin(), values_.end(), p.*coordinate_) -
                          values_.begin());
}

int StartSearch::count(const Vec3& p, int nearby) const {
  const double x = p.*coordinate_;
  const int size = static_cast<int>(values_.size());
  while (nearby < size && values_[nearby] <= x) ++nearby;
  while (nearby > 0 && values_[nearby - 1] > x) --nearby;
  return nearby;
}

void StartSearch::add(std::vector<Start>& starts, int below, int above, const GridEntry& entry) {
  for (int plane = below; plane < above; ++plane) starts.push_back({plane, entry});
}

/// Sides are followed counter-clockwise: a curve that has what is above on its left comes in where
/// the side steps down.
void StartSearch::scan_side(int side) {
  const int across = grid_.columns - 2, up = grid_.rows - 2;
  const bool along_u = side % 2 == 0;
  const int edges = along_u ? grid_.columns - 1 : grid_.rows - 1;
  const auto point = [&](int t) -> const Vec3& {
    const int from = side < 2 ? t : edges - t;
    return along_u ? grid_.at(from, side == 0 ? 0 : grid_.rows - 1)
                   : grid_.at(side == 1 ? grid_.columns - 1 : 0, from);
  };
  constexpr Edge kEdges[] = {Edge::ab, Edge::bc, Edge::cd, Edge::da};
  int before = count(point(0));
  for (int t = 0; t < edges; ++t) {
    const int after = count(point(t + 1), before);
    const int cell = side < 2 ? t : edges - 1 - t;
    const GridEntry entry{along_u     ? cell
                          : side == 1 ? across
                                      : 0,
                          !along_u    ? cell
                          : side == 2 ? up
                                      : 0,
                          kEdges[side]};
    add(lines_, after, before, entry);
    before = after;
  }
}

void StartSearch::search(int level, int column, int row, Planes planes) {
  const GridTree::LevelShape shape = tree_.shape(level);
  if (column >= shape.columns || row >= shape.rows) return;
  const GridTree::Node& node = tree_.node(level, column, row);
  if (!node.extreme) return;
  const auto begin = values_.begin();
  planes.first = static_cast<int>(
      std::upper_bound(begin + planes.first, begin + planes.last, node.low) - begin);
  planes.last = static_cast<int>(
      std::upper_bound(begin + planes.first, begin + planes.last, node.high) - begin);
  if (planes.empty()) return;
  if (level == 0) {
    scan_leaf(column, row, planes);
    return;
  }
  const int half = GridTree::kLeafCells << (level - 1);
  const int u = 2 * column * half, v = 2 * row * half;
  const int last_u = std::min(u + 2 * half, grid_.columns - 1);
  const int last_v = std::min(v + 2 * half, grid_.rows - 1);
  if (u + half < last_u) scan_column(u + half, v, last_v - v, planes);
  if (v + half < last_v) scan_row(u, v + half, last_u - u, planes);
  for (int j = 0; j < 2; ++j)
    for (int i = 0; i < 2; ++i) search(level - 1, 2 * column + i, 2 * row + j, planes);
}

/// A ring goes round a point of the grid and crosses that point's row.
void StartSearch::scan_leaf(int column, int row, Planes planes) {
  const int u = column * GridTree::kLeafCells, v = row * GridTree::kLeafCells;
  const int last_u = std::min(u + GridTree::kLeafCells, grid_.columns - 1);
  const int last_v = std::min(v + GridTree::kLeafCells, grid_.rows - 1);
  for (int j = v + 1; j < last_v; ++j) scan_row(u, j, last_u - u, planes);
}

void StartSearch::scan_row(int u, int v, int edges, Planes planes) {
  int a = count(grid_.at(u, v));
  for (int i = u; i < u + edges; ++i) {
    const int b = count(grid_.at(i + 1, v), a);
    add(rings_, std::max(b, planes.first), std::min(a, planes.last), {i, v, Edge::ab});
    add(rings_, std::max(a, planes.first), std::min(b, planes.last), {i, v - 1, Edge::cd});
    a = b;
  }
}

void StartSearch::scan_column(int u, int v, int edges, Planes planes) {
  int a = count(grid_.at(u, v));
  for (int j = v; j < v + edges; ++j) {
    const int d = count(grid_.at(u, j + 1), a);
    add(rings_, std::max(a, planes.first), std::min(d, planes.last), {u, j, Edge::da});
    add(rings_, std::max(d, planes.first), std::min(a, planes.last), {u - 1, j, Edge::bc});
    a = d;
  }
}

void StartSearch::gather(std::vector<Start>& starts, std::vector<int>& offsets,
                         std::vector<GridEntry>& entries) const {
  offsets.assign(values_.size() + 1, 0);
  for (const Start& s : starts) ++offsets[s.plane + 1];
  for (std::size_t k = 1; k < offsets.size(); ++k) offsets[k] += offsets[k - 1];
  entries.resize(starts.size());
  std::vector<int> next(offsets.begin(), offsets.end() - 1);
  for (const Start& s : starts) entries[next[s.plane]++] = s.entry;
}

}  // namespace limitgauge::engine::surface
