#include "engine/surface/cell/cell_grid.h"

#include <algorithm>
#include <limits>

namespace limitgauge::engine::surface {

CellGrid::CellGrid(const CellPatch& patch, double offset_mm, const std::array<bool, 4>& rim)
    : m_(patch.cells()), rim_(rim) {
  for (int c = 0; c < 4; ++c) extraordinary_[c] = !patch.ring(c).regular();
  cells_.reserve(static_cast<std::size_t>(m_) * static_cast<std::size_t>(m_));
  for (int v = 0; v < m_; ++v)
    for (int u = 0; u < m_; ++u) {
      const auto net = control_cell(patch, u, v);
      cells_.push_back(net ? offset_bounds(*net, offset_mm) : DerivativeBounds{});
    }
}

bool CellGrid::at_extraordinary(int u, int v, int width) const {
  const auto near = [&](int corner, bool left, bool below) {
    return extraordinary_[corner] && (left ? u < width : u >= m_ - width) &&
           (below ? v < width : v >= m_ - width);
  };
  return near(0, true, true) || near(1, false, true) || near(2, false, false) ||
         near(3, true, false);
}

MeshBound CellGrid::bound(int u, int v) const {
  constexpr std::size_t kMost = 9;
  std::array<const DerivativeBounds*, kMost> block{};
  std::size_t count = 0;
  const DerivativeBounds& own = at(u, v);
  MeshBound::Bend bend;
  const auto add = [&](const DerivativeBounds& cell, int side) {
    double& of = rim_[side] ? bend.rim : bend.smooth;
    of = std::max(of, side_bend(cell, side % 2 == 0, own.normal));
  };
  for (int j = std::max(0, v - 1); j <= std::min(m_ - 1, v + 1); ++j)
    for (int i = std::max(0, u - 1); i <= std::min(m_ - 1, u + 1); ++i) {
      const DerivativeBounds& cell = at(i, j);
      block[count++] = &cell;
      if (j == 0) add(cell, 0);
      if (i == m_ - 1) add(cell, 1);
      if (j == m_ - 1) add(cell, 2);
      if (i == 0) add(cell, 3);
    }
  return {own, std::span(block).first(count), bend};
}

std::array<int, 2> CellGrid::on_side(int side, int t) const {
  switch (side) {
    case 0:
      return {t, 0};
    case 1:
      return {m_ - 1, t};
    case 2:
      return {t, m_ - 1};
    default:
      return {0, t};
  }
}

bool CellGrid::meets(int u, int v) const {
  return (v <= 1 && !rim_[0]) || (u >= m_ - 2 && !rim_[1]) || (v >= m_ - 2 && !rim_[2]) ||
         (u <= 1 && !rim_[3]);
}

SplitBound CellGrid::side_bound(int side, int t) const {
  constexpr double kNoBound = std::numeric_limits<double>::infinity();
  const auto [u, v] = on_side(side, t);
  const DerivativeBounds& cell = at(u, v);
  if (!cell.proven) return {kNoBound, kNoBound, 0};
  const bool in_u = side % 2 == 0;
  const SplitBound& second = in_u ? cell.duu : cell.dvv;
  return {second.along / 8, std::min(second.across, side_bend(cell, in_u, cell.normal)) / 8, 0};
}

SplitBound CellGrid::side_bound_but(int side, int width) const {
  SplitBound largest;
  for (int t = 0; t < m_; ++t) {
    const auto [u, v] = on_side(side, t);
    if (at_extraordinary(u, v, width)) continue;
    const SplitBound bound = side_bound(side, t);
    largest = {std::max(largest.along, bound.along), std::max(largest.across, bound.across), 0};
  }
  return largest;
}

}  // namespace limitgauge::engine::surface
