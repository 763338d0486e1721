#include "engine/strategy/clearing_field.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "engine/strategy/distance_field.h"

namespace limitgauge::engine::strategy {
namespace {

/// More discs than this cost more time than their accuracy saves in roughing.
constexpr int kMostDiscs = 12;

std::vector<std::uint8_t> above(const HeightMap& map, double z) {
  std::vector<std::uint8_t> set(map.z.size());
  for (std::size_t i = 0; i < set.size(); ++i) set[i] = map.z[i] > z;
  return set;
}

/// The raster's middle line along its longer side, as a seed for clearing an empty area.
std::vector<std::uint8_t> middle_line(const Raster& r) {
  std::vector<std::uint8_t> set(r.size(), 0);
  const int half = std::min(r.columns, r.rows) / 2;
  const bool wide = r.columns >= r.rows;
  for (int i = half; i <= (wide ? r.columns : r.rows) - 1 - half; ++i) {
    const int column = wide ? i : r.columns / 2, row = wide ? r.rows / 2 : i;
    set[static_cast<std::size_t>(row) * r.columns + column] = 1;
  }
  if (std::find(set.begin(), set.end(), 1) == set.end())
    set[static_cast<std::size_t>(r.rows / 2) * r.columns + r.columns / 2] = 1;
  return set;
}

}  // namespace

std::vector<Disc> disc_stack(const model::Cutter& cutter, double allowance_mm, double fineness_mm) {
  const double corner = cutter.type == model::CutterType::ball   ? cutter.radius_mm()
                        : cutter.type == model::CutterType::flat ? 0.0
                                                                 : cutter.corner_radius_mm;
  const double flat = cutter.radius_mm() - corner, rounding = corner + allowance_mm;
  const double quarter = std::numbers::pi / 2;
  const int steps =
      std::clamp(static_cast<int>(std::ceil(rounding * quarter / fineness_mm)), 1, kMostDiscs);
  std::vector<Disc> discs;
  for (int k = 0; k < steps; ++k)
    discs.push_back({corner - rounding * std::cos(quarter * k / steps),
                     flat + rounding * std::sin(quarter * (k + 1) / steps)});
  return discs;
}

LevelField level_field(const HeightMap& map, const std::vector<Disc>& discs, double tip_z_mm) {
  LevelField field;
  field.clear_mm.assign(map.z.size(), std::numeric_limits<float>::infinity());
  // Distances run between pixel centres; the surface lies anywhere in its pixel's square.
  const double pixel = map.raster.pixel_mm / std::numbers::sqrt2;
  for (const Disc& disc : discs) {
    const std::vector<std::uint8_t> set = above(map, tip_z_mm + disc.height_mm);
    if (std::find(set.begin(), set.end(), 1) == set.end()) continue;
    field.anything_forbidden = true;
    const std::vector<float> distance = distance_field(map.raster, set);
    const auto reach = static_cast<float>(disc.radius_mm + pixel);
    for (std::size_t i = 0; i < distance.size(); ++i)
      field.clear_mm[i] = std::min(field.clear_mm[i], distance[i] - reach);
  }
  if (!field.anything_forbidden)
    field.clear_mm = distance_field(map.raster, middle_line(map.raster));
  return field;
}

std::vector<std::size_t> level_signature(const std::vector<float>& sorted_z,
                                         const std::vector<Disc>& discs, double tip_z_mm) {
  std::vector<std::size_t> counts;
  for (const Disc& disc : discs) {
    const double z = tip_z_mm + disc.height_mm;
    const auto first = std::upper_bound(sorted_z.begin(), sorted_z.end(), z);
    counts.push_back(static_cast<std::size_t>(sorted_z.end() - first));
  }
  return counts;
}

}  // namespace limitgauge::engine::strategy
