#include "engine/strategy/raster/clearing_field.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "engine/strategy/raster/distance_field.h"
#include "model/base/angle.h"

namespace limitgauge::engine::strategy {
namespace {

/// More discs than this cost more time than their accuracy saves in roughing.
constexpr int kMostDiscs = 12;

std::vector<std::uint8_t> above(const HeightMap& map, double z) {
  std::vector<std::uint8_t> set(map.z.size());
  for (std::size_t i = 0; i < set.size(); ++i) set[i] = map.z[i] > z;
  return set;
}

/// Radius of the bottom's flat, of the rounding around it, and half angle of the cone above.
struct Profile {
  double flat_mm = 0, corner_mm = 0, cone_rad = 0;
};

Profile profile_of(const model::Cutter& c) {
  return {c.radius_mm() - c.corner_radius_mm, c.corner_radius_mm,
          model::radians(c.taper_angle_deg)};
}

}  // namespace

std::vector<Disc> disc_stack(const model::Cutter& cutter, double allowance_mm, double fineness_mm) {
  const Profile p = profile_of(cutter);
  const double rounding = p.corner_mm + allowance_mm, quarter = std::numbers::pi / 2;
  const auto steps_over = [&](double way_mm) {
    return std::clamp(static_cast<int>(std::ceil(way_mm / fineness_mm)), 1, kMostDiscs);
  };
  const double end = quarter - p.cone_rad;
  const int steps = steps_over(rounding * end);
  std::vector<Disc> discs;
  for (int k = 0; k < steps; ++k)
    discs.push_back({p.corner_mm - rounding * std::cos(end * k / steps),
                     p.flat_mm + rounding * std::sin(end * (k + 1) / steps)});
  if (p.cone_rad <= 0) return discs;
  // From where the rounding meets the cone to where the grown cone is as wide as the shaft.
  const double low = p.corner_mm - rounding * std::cos(end);
  const double inner = p.flat_mm + rounding * std::sin(end);
  const double outer = model::largest_radius_mm(cutter) + allowance_mm;
  const int rings = steps_over(outer - inner);
  for (int k = 0; k < rings; ++k) {
    const double rise = (outer - inner) * k / rings / std::tan(p.cone_rad);
    discs.push_back({low + rise, inner + (outer - inner) * (k + 1) / rings});
  }
  return discs;
}

double profile_radius_mm(const model::Cutter& cutter, double height_mm) {
  const Profile p = profile_of(cutter);
  const double tangent = p.corner_mm * (1 - std::sin(p.cone_rad));
  const double below = p.corner_mm - std::min(height_mm, tangent);
  const double rounded =
      p.flat_mm + std::sqrt(std::max(0.0, p.corner_mm * p.corner_mm - below * below));
  const double cone = std::max(0.0, height_mm - tangent) * std::tan(p.cone_rad);
  return std::min(rounded + cone, model::largest_radius_mm(cutter));
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
  return field;
}

namespace {

/// Pixels of `within` with a height above `z`, as the smallest window that holds them.
Window holding(const HeightMap& map, const Window& within, double z) {
  Window w{within.last_column + 1, within.last_row + 1, within.first_column - 1,
           within.first_row - 1};
  const auto high = [&](float height) { return height > z; };
  for (int j = within.first_row; j <= within.last_row; ++j) {
    const float* row = &map.z[static_cast<std::size_t>(j) * map.raster.columns];
    const float *begin = row + within.first_column, *end = row + within.last_column + 1;
    const float* first = std::find_if(begin, end, high);
    if (first == end) continue;
    const float* last = end - 1;
    while (!high(*last)) --last;
    w.first_row = std::min(w.first_row, j);
    w.last_row = j;
    w.first_column = std::min(w.first_column, static_cast<int>(first - row));
    w.last_column = std::max(w.last_column, static_cast<int>(last - row));
  }
  return w;
}

}  // namespace

NearField near_field(const HeightMap& map, const std::vector<Disc>& discs, double tip_z_mm,
                     const Window& within, double near_mm) {
  const double pixel = map.raster.pixel_mm / std::numbers::sqrt2;
  const double reach = discs.back().radius_mm + pixel + near_mm;
  const int sight = 2 + static_cast<int>(std::ceil(reach / map.raster.pixel_mm));
  const Window seen = overlap(grown(within, sight), whole(map.raster));
  const Window set = holding(map, seen, tip_z_mm + discs.front().height_mm);
  if (set.empty()) return {};
  const Window part = overlap(grown(set, sight), seen);
  NearField field{part_of(map.raster, part), {}};
  field.clear_mm.assign(field.raster.size(), static_cast<float>(near_mm));
  NearDistances near(field.raster, reach);
  const float* corner =
      &map.z[static_cast<std::size_t>(part.first_row) * map.raster.columns + part.first_column];
  for (const Disc& disc : discs) {
    const std::vector<float>& distance =
        near.to_above(corner, map.raster.columns, tip_z_mm + disc.height_mm);
    const auto kept = static_cast<float>(disc.radius_mm + pixel);
    for (std::size_t i = 0; i < distance.size(); ++i)
      field.clear_mm[i] = std::min(field.clear_mm[i], distance[i] - kept);
  }
  return field;
}

std::vector<std::vector<std::size_t>> level_signatures(const HeightMap& map,
                                                       const std::vector<Disc>& discs,
                                                       const std::vector<double>& tips_z_mm) {
  std::vector<double> heights;
  for (const double tip : tips_z_mm)
    for (const Disc& disc : discs) heights.push_back(tip + disc.height_mm);
  std::sort(heights.begin(), heights.end());
  const auto below = [&](double z) {
    return static_cast<std::size_t>(std::lower_bound(heights.begin(), heights.end(), z) -
                                    heights.begin());
  };
  // Pixels by how many of the heights they exceed, then those that exceed each or more.
  std::vector<std::size_t> counts(heights.size() + 1, 0);
  for (const float z : map.z)
    if (std::isfinite(z)) ++counts[below(z)];
  for (std::size_t i = heights.size(); i-- > 0;) counts[i] += counts[i + 1];
  std::vector<std::vector<std::size_t>> signatures;
  for (const double tip : tips_z_mm) {
    auto& signature = signatures.emplace_back();
    for (const Disc& disc : discs) signature.push_back(counts[below(tip + disc.height_mm) + 1]);
  }
  return signatures;
}

}  // namespace limitgauge::engine::strategy
