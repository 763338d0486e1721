#include "engine/strategy/levels/unsure_nodes.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace limitgauge::engine::strategy {
namespace {

/// Steepest slope (tangent) for which sides of nodes are told by heights that may be wrong: beyond
/// that the curve is looked for past the node.
constexpr double kSteepestNode = 20;

double error_of(const TipRaster& tips, int column, int row) {
  const Raster& r = tips.raster;
  double farthest = 0;
  for (const auto& [i, j] :
       {std::pair{column - 1, row}, {column + 1, row}, {column, row - 1}, {column, row + 1}})
    if (i >= 0 && j >= 0 && i < r.columns && j < r.rows)
      farthest = std::max(farthest, std::abs(tips.at(i, j) - tips.at(column, row)));
  return tips.error_mm * (1 + std::min(2 * farthest / r.pixel_mm, kSteepestNode));
}

}  // namespace

UnsureNodes::UnsureNodes(const TipRaster& tips, const CellMask& wanted) {
  if (tips.error_mm <= 0) return;
  for (int j = 0; j < wanted.rows(); ++j)
    for (int i = 0; i < wanted.columns(); ++i)
      if (wanted.set[wanted.index(i, j)] && std::isfinite(tips.at(i, j)))
        nodes_.push_back({tips.at(i, j), error_of(tips, i, j),
                          static_cast<std::size_t>(j) * tips.raster.columns + i});
  std::sort(nodes_.begin(), nodes_.end(), [](const Node& a, const Node& b) {
    return std::pair(a.z, a.at) < std::pair(b.z, b.at);
  });
  for (const Node& node : nodes_) largest_error_mm_ = std::max(largest_error_mm_, node.error_mm);
}

std::span<const UnsureNodes::Node> UnsureNodes::near(double height_mm) const {
  const auto first = std::lower_bound(nodes_.begin(), nodes_.end(), height_mm - largest_error_mm_,
                                      [](const Node& node, double z) { return node.z < z; });
  const auto last = std::upper_bound(first, nodes_.end(), height_mm + largest_error_mm_,
                                     [](double z, const Node& node) { return z < node.z; });
  return {first, last};
}

}  // namespace limitgauge::engine::strategy
