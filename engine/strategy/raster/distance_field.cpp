#include "engine/strategy/raster/distance_field.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace limitgauge::engine::strategy {
namespace {

using Squared = std::int64_t;

/// Distance to the nearest set pixel in the same column, `far` where there is none.
std::vector<std::int32_t> column_distances(const Raster& r, const std::vector<std::uint8_t>& set,
                                           std::int32_t far) {
  std::vector<std::int32_t> g(r.size());
  for (int i = 0; i < r.columns; ++i) g[i] = set[i] ? 0 : far;
  for (int j = 1; j < r.rows; ++j) {
    const std::size_t row = static_cast<std::size_t>(j) * r.columns;
    for (int i = 0; i < r.columns; ++i)
      g[row + i] = set[row + i] ? 0 : std::min(far, g[row + i - r.columns] + 1);
  }
  for (int j = r.rows - 2; j >= 0; --j) {
    const std::size_t row = static_cast<std::size_t>(j) * r.columns;
    for (int i = 0; i < r.columns; ++i)
      g[row + i] = std::min(g[row + i], g[row + i + r.columns] + 1);
  }
  return g;
}

/// Lower envelope of the parabolas of one row.
class RowEnvelope {
 public:
  explicit RowEnvelope(int columns) : columns_(columns), apex_(columns), start_(columns) {}

  void solve(const std::int32_t* g, double pixel_mm, float* distance) {
    count_ = 1;
    apex_[0] = start_[0] = 0;
    for (int u = 1; u < columns_; ++u) insert(g, u);
    for (int u = columns_ - 1, q = count_ - 1; u >= 0; --u) {
      distance[u] =
          static_cast<float>(std::sqrt(static_cast<double>(value(g, u, apex_[q]))) * pixel_mm);
      if (u == start_[q]) --q;
    }
  }

 private:
  static Squared value(const std::int32_t* g, Squared x, int i) {
    return (x - i) * (x - i) + static_cast<Squared>(g[i]) * g[i];
  }
  void insert(const std::int32_t* g, int u) {
    while (count_ > 0 &&
           value(g, start_[count_ - 1], apex_[count_ - 1]) > value(g, start_[count_ - 1], u))
      --count_;
    if (count_ == 0) {
      apex_[count_++] = u;
      return;
    }
    const int i = apex_[count_ - 1];
    const Squared numerator = static_cast<Squared>(u) * u - static_cast<Squared>(i) * i +
                              static_cast<Squared>(g[u]) * g[u] - static_cast<Squared>(g[i]) * g[i];
    const Squared from = 1 + numerator / (2 * static_cast<Squared>(u - i));
    if (from >= columns_) return;
    apex_[count_] = u;
    start_[count_++] = static_cast<int>(from);
  }

  int columns_, count_ = 0;
  std::vector<int> apex_, start_;
};

}  // namespace

std::vector<float> distance_field(const Raster& raster, const std::vector<std::uint8_t>& set) {
  std::vector<float> distance(raster.size(), std::numeric_limits<float>::infinity());
  if (std::find(set.begin(), set.end(), 1) == set.end()) return distance;
  const std::int32_t far = 2 * (raster.columns + raster.rows);
  const std::vector<std::int32_t> g = column_distances(raster, set, far);
  RowEnvelope envelope(raster.columns);
  for (int j = 0; j < raster.rows; ++j) {
    const std::size_t row = static_cast<std::size_t>(j) * raster.columns;
    envelope.solve(&g[row], raster.pixel_mm, &distance[row]);
  }
  return distance;
}

}  // namespace limitgauge::engine::strategy
