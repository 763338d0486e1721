#include "engine/strategy/levels/curve_need.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace limitgauge::engine::strategy {
namespace {

/// Gaps are measured along the raster's line and not along the curve, which is shorter or up to so
/// many times as long, and a few cells more at their ends.
constexpr double kLongerAlong = 2, kCellsMore = 8;

/// One flag a piece of the line: from points[k] to points[k + 1].
std::vector<char> near_pieces(const Isoline& line, const CellMask& near) {
  std::vector<char> wanted;
  for (std::size_t k = 0; k + 1 < line.points.size(); ++k) {
    const FlatPoint middle = lerp(line.points[k], line.points[k + 1], 0.5);
    wanted.push_back(near.at(middle.x, middle.y));
  }
  return wanted;
}

/// Turns a closed line, and the flags of its pieces, so that it begins with the first piece that is
/// wanted after one that is not.
void begin_after_gap(Isoline& line, std::vector<char>& wanted) {
  const std::size_t n = wanted.size();
  for (std::size_t k = 0; k < n; ++k) {
    if (!wanted[k] || wanted[(k + n - 1) % n]) continue;
    const auto by = static_cast<std::ptrdiff_t>(k);
    line.points.pop_back();
    std::rotate(line.points.begin(), line.points.begin() + by, line.points.end());
    line.points.push_back(line.points.front());
    std::rotate(wanted.begin(), wanted.begin() + by, wanted.end());
    return;
  }
}

double length_between(const Isoline& line, std::size_t begin, std::size_t end) {
  double sum = 0;
  for (std::size_t k = begin; k < end; ++k) sum += distance(line.points[k], line.points[k + 1]);
  return sum;
}

double touched_between(const Isoline& line, std::size_t begin, std::size_t end,
                       const CellMask& touched) {
  double sum = 0;
  for (std::size_t k = begin; k < end; ++k) {
    const FlatPoint middle = lerp(line.points[k], line.points[k + 1], 0.5);
    if (touched.at(middle.x, middle.y)) sum += distance(line.points[k], line.points[k + 1]);
  }
  return sum;
}

/// Fills gaps that may be cut: those between two wanted pieces and, of a closed line, the last one.
void fill_gaps(const Isoline& line, const CurveNeed& need, std::vector<char>& wanted) {
  const double more = kCellsMore * need.cells.nodes.pixel_mm;
  const double longest = kLongerAlong * need.bridged_mm + more;
  const double repeated = kLongerAlong * need.repeated_mm + more;
  const std::size_t n = wanted.size();
  for (std::size_t k = 0; k < n;) {
    std::size_t end = k + 1;
    while (end < n && wanted[end] == wanted[k]) ++end;
    const bool inner = k > 0 && (end < n || line.closed);
    if (!wanted[k] && inner && length_between(line, k, end) <= longest &&
        touched_between(line, k, end, need.touched) <= repeated)
      std::fill(wanted.begin() + static_cast<std::ptrdiff_t>(k),
                wanted.begin() + static_cast<std::ptrdiff_t>(end), 1);
    k = end;
  }
}

std::vector<Isoline> stretches(const Isoline& line, const std::vector<char>& wanted) {
  std::vector<Isoline> made;
  for (std::size_t k = 0; k < wanted.size(); ++k) {
    if (!wanted[k]) continue;
    if (k == 0 || !wanted[k - 1]) made.push_back({{line.points[k]}, false});
    made.back().points.push_back(line.points[k + 1]);
  }
  return made;
}

}  // namespace

CellMask widened(const CellMask& mask, int cells) {
  CellMask along = mask;
  for (int j = 0; j < mask.rows(); ++j)
    for (int i = 0; i < mask.columns(); ++i)
      if (mask.set[mask.index(i, j)])
        for (int c = std::max(0, i - cells); c <= std::min(mask.columns() - 1, i + cells); ++c)
          along.set[mask.index(c, j)] = 1;
  CellMask wide = along;
  for (int j = 0; j < mask.rows(); ++j)
    for (int i = 0; i < mask.columns(); ++i)
      if (along.set[mask.index(i, j)])
        for (int r = std::max(0, j - cells); r <= std::min(mask.rows() - 1, j + cells); ++r)
          wide.set[mask.index(i, r)] = 1;
  return wide;
}

std::vector<Isoline> needed_stretches(const Isoline& line, const CurveNeed& near) {
  std::vector<char> wanted = near_pieces(line, near.cells);
  if (std::find(wanted.begin(), wanted.end(), 1) == wanted.end()) return {};
  Isoline turned = line;
  if (turned.closed) begin_after_gap(turned, wanted);
  fill_gaps(turned, near, wanted);
  if (std::find(wanted.begin(), wanted.end(), 0) == wanted.end()) return {line};
  // The last gap of a closed line may have been the one filled.
  if (turned.closed) begin_after_gap(turned, wanted);
  return stretches(turned, wanted);
}

}  // namespace limitgauge::engine::strategy
