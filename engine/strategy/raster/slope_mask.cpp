#include "engine/strategy/raster/slope_mask.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <queue>
#include <utility>

namespace limitgauge::engine::strategy {
namespace {

SlopeCell measure_cell(const std::array<double, 4>& z, double pixel, double lowest) {
  SlopeCell cell;
  double low = std::numeric_limits<double>::infinity(), high = -low;
  bool whole = true;
  for (const double corner : z) {
    if (!std::isfinite(corner)) {
      whole = false;
      continue;
    }
    low = std::min(low, std::max(corner, lowest));
    high = std::max(high, std::max(corner, lowest));
  }
  cell.covered = std::isfinite(low);
  if (!cell.covered) return cell;
  cell.low_mm = whole ? low : lowest;
  cell.high_mm = high;
  // Corners counter-clockwise from the lower left.
  const auto at = [&](int k) { return std::max(z[k], lowest); };
  const double dx = (at(1) + at(2) - at(0) - at(3)) / (2 * pixel);
  const double dy = (at(2) + at(3) - at(0) - at(1)) / (2 * pixel);
  cell.slope_rad = whole ? std::atan(std::hypot(dx, dy)) : std::numbers::pi / 2;
  return cell;
}

template <class Wanted>
CellMask select(const SlopeCells& slopes, const Wanted& wanted) {
  CellMask mask(slopes.nodes);
  for (std::size_t i = 0; i < mask.set.size(); ++i)
    mask.set[i] = slopes.cells[i].covered && wanted(slopes.cells[i].slope_rad);
  return mask;
}

/// Distances over the cells from those of a mask (Dijkstra), as far as asked for.
class Spread {
 public:
  Spread(const SlopeCells& slopes, double farthest)
      : slopes_(slopes),
        farthest_(farthest),
        away_(slopes.cells.size(), std::numeric_limits<double>::infinity()) {}

  CellMask from(CellMask mask) {
    // Cells of the mask count as a whole: what is beside them is as near as their border.
    source_ = mask.set;
    for (std::size_t i = 0; i < source_.size(); ++i)
      if (source_[i]) away_[i] = 0;
    for (std::size_t i = 0; i < source_.size(); ++i)
      if (source_[i] && at_border(mask, i)) open_.push({0, i});
    while (!open_.empty()) {
      const auto [away, i] = open_.top();
      open_.pop();
      if (away <= away_[i]) pass_on(mask, i);
    }
    for (std::size_t i = 0; i < mask.set.size(); ++i) mask.set[i] = away_[i] <= farthest_;
    return mask;
  }

 private:
  /// Whether a cell of the mask has one beside it that is not: others pass nothing on.
  bool at_border(const CellMask& mask, std::size_t i) const {
    const auto wide = static_cast<std::size_t>(mask.columns());
    const int column = static_cast<int>(i % wide), row = static_cast<int>(i / wide);
    for (int r = std::max(row - 1, 0); r <= std::min(row + 1, mask.rows() - 1); ++r)
      for (int c = std::max(column - 1, 0); c <= std::min(column + 1, mask.columns() - 1); ++c)
        if (!source_[mask.index(c, r)]) return true;
    return false;
  }
  void reach(std::size_t i, double away) {
    if (away > farthest_ || away >= away_[i]) return;
    away_[i] = away;
    open_.push({away, i});
  }
  void pass_on(const CellMask& mask, std::size_t i) {
    const auto wide = static_cast<std::size_t>(mask.columns());
    const int column = static_cast<int>(i % wide), row = static_cast<int>(i / wide);
    for (int dj = -1; dj <= 1; ++dj)
      for (int di = -1; di <= 1; ++di) {
        const int c = column + di, r = row + dj;
        if (c < 0 || r < 0 || c >= mask.columns() || r >= mask.rows()) continue;
        const std::size_t next = mask.index(c, r);
        if (!slopes_.cells[next].covered) continue;
        reach(next, away_[i] + std::hypot(mask.nodes.pixel_mm * std::hypot(di, dj), height(i)));
      }
  }
  /// What has to be climbed to get across a cell.
  double height(std::size_t i) const {
    return source_[i] ? 0.0 : slopes_.cells[i].high_mm - slopes_.cells[i].low_mm;
  }

  const SlopeCells& slopes_;
  double farthest_;
  std::vector<double> away_;
  std::vector<std::uint8_t> source_;
  using Entry = std::pair<double, std::size_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open_;
};

}  // namespace

bool CellMask::at(double x, double y) const {
  const double i = std::floor((x - nodes.x0) / nodes.pixel_mm);
  const double j = std::floor((y - nodes.y0) / nodes.pixel_mm);
  if (i < 0 || j < 0 || i >= columns() || j >= rows()) return false;
  return set[index(static_cast<int>(i), static_cast<int>(j))];
}

CellMask both(CellMask a, const CellMask& b) {
  for (std::size_t i = 0; i < a.set.size(); ++i) a.set[i] = a.set[i] && b.set[i];
  return a;
}

SlopeCells measure_slopes(const TipRaster& tips, double lowest_mm) {
  SlopeCells slopes{tips.raster, {}};
  slopes.cells.reserve(tips.z.size());
  for (int j = 0; j + 1 < tips.raster.rows; ++j)
    for (int i = 0; i + 1 < tips.raster.columns; ++i)
      slopes.cells.push_back(
          measure_cell({tips.at(i, j), tips.at(i + 1, j), tips.at(i + 1, j + 1), tips.at(i, j + 1)},
                       tips.raster.pixel_mm, lowest_mm));
  return slopes;
}

CellMask steep_cells(const SlopeCells& slopes, double angle_rad) {
  return select(slopes, [=](double slope) { return slope >= angle_rad; });
}
CellMask shallow_cells(const SlopeCells& slopes, double angle_rad) {
  return select(slopes, [=](double slope) { return slope < angle_rad; });
}

CellMask grown(const CellMask& mask, const SlopeCells& slopes, double distance_mm) {
  return Spread(slopes, distance_mm).from(mask);
}

}  // namespace limitgauge::engine::strategy
