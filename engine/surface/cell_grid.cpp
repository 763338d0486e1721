#include "engine/surface/cell_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace limitgauge::engine::surface {

CellGrid::CellGrid(const CellPatch& patch, double offset_mm) : m_(patch.cells()) {
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
  double bend = 0;
  for (int j = std::max(0, v - 1); j <= std::min(m_ - 1, v + 1); ++j)
    for (int i = std::max(0, u - 1); i <= std::min(m_ - 1, u + 1); ++i) {
      const DerivativeBounds& cell = at(i, j);
      block[count++] = &cell;
      if (j == 0 || j == m_ - 1) bend = std::max(bend, side_bend(cell, true, own.normal));
      if (i == 0 || i == m_ - 1) bend = std::max(bend, side_bend(cell, false, own.normal));
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

double CellGrid::side_bound(int side, int t) const {
  const auto [u, v] = on_side(side, t);
  const DerivativeBounds& cell = at(u, v);
  if (!cell.proven) return std::numeric_limits<double>::infinity();
  const bool in_u = side % 2 == 0;
  const SplitBound& second = in_u ? cell.duu : cell.dvv;
  const double across = std::min(second.across, side_bend(cell, in_u, cell.normal));
  return std::hypot(second.along, across) / 8;
}

double CellGrid::side_bound_but(int side, int width) const {
  double largest = 0;
  for (int t = 0; t < m_; ++t) {
    const auto [u, v] = on_side(side, t);
    if (!at_extraordinary(u, v, width)) largest = std::max(largest, side_bound(side, t));
  }
  return largest;
}

}  // namespace limitgauge::engine::surface
