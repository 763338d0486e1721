#pragma once
// Brute force: how far points of the surface are from all that a path cuts.

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "engine/strategy/locations/cutter_locations.h"
#include "engine/strategy/locations/limit_locations.h"
#include "engine/surface/patch_model.h"
#include "tests/engine/lift_probe.h"

namespace limitgauge::test {

struct SurfacePoint {
  Vec3 p, normal;
};

/// Points of the limit surface with their normals, 2^depth cells a patch side.
inline std::vector<SurfacePoint> surface_points(const model::Cage& cage, int depth) {
  // A precision that no test asks for makes every patch as deep as it may be.
  const engine::surface::PatchModel dense(cage, {1e-9, 0, depth}, {});
  std::vector<SurfacePoint> points;
  for (const auto& patch : dense.patches())
    for (std::size_t i = 0; i < patch.limit.points.size(); ++i)
      points.push_back({patch.limit.points[i], patch.limit.normals[i]});
  return points;
}

/// Tips along polylines, close together, in square bins.
class SweptTips {
 public:
  SweptTips(const std::vector<std::vector<Vec3>>& lines, double spacing_mm) {
    std::vector<Vec3> tips;
    for (const auto& line : lines)
      for (std::size_t i = 1; i < line.size(); ++i) {
        const int parts = 1 + static_cast<int>(distance(line[i - 1], line[i]) / spacing_mm);
        for (int k = 0; k <= parts; ++k)
          tips.push_back(lerp(line[i - 1], line[i], static_cast<double>(k) / parts));
      }
    for (const Vec3& p : tips) box_.add(p);
    if (tips.empty()) return;
    columns_ = 1 + column(box_.high.x);
    rows_ = 1 + row(box_.high.y);
    bins_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
    for (const Vec3& p : tips) bins_[bin(column(p.x), row(p.y))].push_back(p);
  }

  /// Distance from `p` to the nearest position of the fluted part, negative inside; infinite where
  /// none is within its radius and `beyond_mm`.
  double distance_to(const model::Cutter& cutter, const Vec3& p, double beyond_mm) const {
    double least = std::numeric_limits<double>::infinity();
    const double reach = model::largest_radius_mm(cutter) + beyond_mm;
    for (int j = std::max(0, row(p.y - reach)); j <= std::min(rows_ - 1, row(p.y + reach)); ++j)
      for (int i = std::max(0, column(p.x - reach));
           i <= std::min(columns_ - 1, column(p.x + reach)); ++i)
        for (const Vec3& tip : bins_[bin(i, j)]) {
          const double d = std::hypot(p.x - tip.x, p.y - tip.y), z = p.z - tip.z;
          if (d < reach && z > -beyond_mm) least = std::min(least, open_distance(cutter, d, z));
        }
    return least;
  }

 private:
  static constexpr double kBin = 0.5;
  int column(double x) const { return static_cast<int>(std::floor((x - box_.low.x) / kBin)); }
  int row(double y) const { return static_cast<int>(std::floor((y - box_.low.y) / kBin)); }
  std::size_t bin(int i, int j) const { return static_cast<std::size_t>(j) * columns_ + i; }

  model::Box3 box_;
  int columns_ = 0, rows_ = 0;
  std::vector<std::vector<Vec3>> bins_;
};

/// The tip that touches a point of the surface at a distance, by its normal.
inline Vec3 contact_tip(const model::Cutter& cutter, const SurfacePoint& s, double distance_mm) {
  const double r = cutter.corner_radius_mm, flat = cutter.radius_mm() - r;
  const double level = std::hypot(s.normal.x, s.normal.y);
  const Vec3 out = level > 1e-9 ? Vec3{s.normal.x / level, s.normal.y / level, 0} : Vec3{};
  return s.p + s.normal * (r + distance_mm) + out * flat - Vec3{0, 0, r};
}

struct Coverage {
  double gouge_mm = 0;  ///< deepest below the allowance surface
  double uncut_mm = 0;  ///< most left above it where the cutter can touch
  SurfacePoint gouged, left;
  std::size_t reachable = 0;
};

/// What `lines` leave and take away at points that face up; a point counts as reachable where the
/// tip that touches it by its normal stands within `slack_mm` of the cutter location surface and
/// not below `floor_mm`.
inline Coverage cover(const std::vector<std::vector<Vec3>>& lines, const model::Cutter& cutter,
                      double allowance_mm, const std::vector<SurfacePoint>& surface,
                      const engine::strategy::CutterLocations& locations, double slack_mm,
                      double floor_mm) {
  constexpr double kSpacing = 0.1, kBeyond = 0.6;
  const SweptTips tips(lines, kSpacing);
  Coverage found;
  for (const SurfacePoint& s : surface) {
    const double left = tips.distance_to(cutter, s.p, allowance_mm + kBeyond) - allowance_mm;
    if (-left > found.gouge_mm) {
      found.gouge_mm = -left;
      found.gouged = s;
    }
    const Vec3 tip = contact_tip(cutter, s, allowance_mm);
    if (s.normal.z < 0 || tip.z < floor_mm) continue;
    const auto z = locations.tip_z(tip.x, tip.y);
    if (z && *z > tip.z + slack_mm) continue;
    ++found.reachable;
    if (left > found.uncut_mm) {
      found.uncut_mm = left;
      found.left = s;
    }
  }
  return found;
}

}  // namespace limitgauge::test
