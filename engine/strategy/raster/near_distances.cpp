#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/strategy/raster/distance_field.h"

namespace limitgauge::engine::strategy {
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
