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

namespace {

/// The greatest float that is no greater: a float exceeds it exactly when it exceeds `z`.
float rounded_down(double z) {
  const auto nearest = static_cast<float>(z);
  return static_cast<double>(nearest) > z
             ? std::nextafter(nearest, -std::numeric_limits<float>::infinity())
             : nearest;
}

}  // namespace

NearDistances::NearDistances(const Raster& raster, double reach_mm)
    : raster_(raster),
      reach_(static_cast<std::uint16_t>(
          std::clamp(std::ceil(reach_mm / raster.pixel_mm), 1.0,
                     static_cast<double>(std::numeric_limits<std::uint16_t>::max() - 2)))),
      reach_mm_(static_cast<float>(std::min(reach_mm, reach_ * raster.pixel_mm))),
      in_column_(raster.size()),
      distance_(raster.size()) {
  apexes_.reserve(static_cast<std::size_t>(raster.columns));
}

void NearDistances::measure_columns(const float* heights, int stride, double z) {
  const float level = rounded_down(z);
  const auto beyond = static_cast<std::uint16_t>(reach_ + 1);
  for (int j = 0; j < raster_.rows; ++j) {
    const float* row = heights + static_cast<std::ptrdiff_t>(j) * stride;
    std::uint16_t* g = &in_column_[static_cast<std::size_t>(j) * raster_.columns];
    const std::uint16_t* below = j > 0 ? g - raster_.columns : nullptr;
    for (int i = 0; i < raster_.columns; ++i) {
      const auto next = static_cast<std::uint16_t>(below ? below[i] + 1 : beyond);
      g[i] = row[i] > level ? std::uint16_t{0} : std::min(beyond, next);
    }
  }
  for (int j = raster_.rows - 2; j >= 0; --j) {
    std::uint16_t* g = &in_column_[static_cast<std::size_t>(j) * raster_.columns];
    const std::uint16_t* above = g + raster_.columns;
    for (int i = 0; i < raster_.columns; ++i)
      g[i] = std::min(g[i], static_cast<std::uint16_t>(above[i] + 1));
  }
}

/// A parabola joins the lower envelope from the right.
void NearDistances::insert(int column, std::int64_t height2) {
  const auto value = [](const Apex& a, std::int64_t x) {
    return (x - a.column) * (x - a.column) + a.height2;
  };
  const Apex fresh{column, 0, height2};
  while (!apexes_.empty() &&
         value(apexes_.back(), apexes_.back().from) > value(fresh, apexes_.back().from))
    apexes_.pop_back();
  if (apexes_.empty()) {
    apexes_.push_back(fresh);
    return;
  }
  const Apex& last = apexes_.back();
  const std::int64_t x = column, l = last.column;
  const std::int64_t numerator = x * x - l * l + height2 - last.height2;
  // Exact: integers of this size divide in double precision without crossing a whole number.
  const auto from = 1 + static_cast<std::int64_t>(std::floor(static_cast<double>(numerator) /
                                                             static_cast<double>(2 * (x - l))));
  if (from >= raster_.columns) return;
  apexes_.push_back({column, static_cast<int>(from), height2});
}

void NearDistances::measure_row(const std::uint16_t* g, float* distance) {
  apexes_.clear();
  const int columns = raster_.columns;
  for (int u = 0; u < columns; ++u) {
    if (g[u] > reach_) continue;
    // Inside a run of set pixels only the ends are nearest to anything outside it.
    if (g[u] == 0 && u > 0 && u + 1 < columns && g[u - 1] == 0 && g[u + 1] == 0) continue;
    insert(u, static_cast<std::int64_t>(g[u]) * g[u]);
  }
  if (apexes_.empty()) {
    std::fill(distance, distance + columns, reach_mm_);
    return;
  }
  const std::int64_t far2 = static_cast<std::int64_t>(reach_) * reach_;
  for (std::size_t q = 0; q < apexes_.size(); ++q) {
    const Apex& a = apexes_[q];
    const int end = q + 1 < apexes_.size() ? apexes_[q + 1].from : columns;
    for (int u = q == 0 ? 0 : a.from; u < end; ++u) {
      const std::int64_t x = u - a.column;
      distance[u] = g[u] == 0 ? 0.0F : static_cast<float>(std::min(far2, x * x + a.height2));
    }
  }
  const auto pixel = static_cast<float>(raster_.pixel_mm);
  for (int u = 0; u < columns; ++u)
    distance[u] = std::min(reach_mm_, std::sqrt(distance[u]) * pixel);
}

const std::vector<float>& NearDistances::to_above(const float* heights, int stride, double z) {
  measure_columns(heights, stride, z);
  for (int j = 0; j < raster_.rows; ++j) {
    const std::size_t row = static_cast<std::size_t>(j) * raster_.columns;
    measure_row(&in_column_[row], &distance_[row]);
  }
  return distance_;
}

}  // namespace limitgauge::engine::strategy
