#pragma once
// Brute force: how deep a cutter goes below the surface moved out by the allowance, measured
// against points of the surface itself.

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "model/part/cutter.h"
#include "model/part/toolpath.h"

namespace limitgauge::test {

using model::Vec3;

/// Distance from `p` to the cutter with its tip at `tip`, negative inside (flat, ball, bull; the
/// shaft goes on upwards for ever).
inline double cutter_distance(const model::Cutter& cutter, const Vec3& tip, const Vec3& p) {
  const double r = cutter.radius_mm();
  const double corner = cutter.type == model::CutterType::ball   ? r
                        : cutter.type == model::CutterType::flat ? 0.0
                                                                 : cutter.corner_radius_mm;
  // The cutter is the upright shaft of radius r - corner from height `corner` up, grown by it.
  const double out = std::hypot(p.x - tip.x, p.y - tip.y) - (r - corner);
  const double below = tip.z + corner - p.z;
  const double outside = std::hypot(std::max(out, 0.0), std::max(below, 0.0));
  return outside + std::min(std::max(out, below), 0.0) - corner;
}

/// Surface points in square bins.
class PointBins {
 public:
  PointBins(const std::vector<Vec3>& points, double bin_mm) : bin_(bin_mm) {
    model::Box3 box;
    for (const Vec3& p : points) box.add(p);
    low_ = box.low;
    columns_ = 1 + static_cast<int>(box.size().x / bin_);
    rows_ = 1 + static_cast<int>(box.size().y / bin_);
    bins_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
    for (const Vec3& p : points) bins_[bin(column(p.x), row(p.y))].push_back(p);
  }

  /// Smallest cutter_distance over the points, looked for within `reach_mm`.
  double nearest(const model::Cutter& cutter, const Vec3& tip, double reach_mm) const {
    double least = std::numeric_limits<double>::infinity();
    for (int j = std::max(0, row(tip.y - reach_mm));
         j <= std::min(rows_ - 1, row(tip.y + reach_mm)); ++j)
      for (int i = std::max(0, column(tip.x - reach_mm));
           i <= std::min(columns_ - 1, column(tip.x + reach_mm)); ++i)
        for (const Vec3& p : bins_[bin(i, j)])
          least = std::min(least, cutter_distance(cutter, tip, p));
    return least;
  }

 private:
  int column(double x) const { return static_cast<int>(std::floor((x - low_.x) / bin_)); }
  int row(double y) const { return static_cast<int>(std::floor((y - low_.y) / bin_)); }
  std::size_t bin(int i, int j) const { return static_cast<std::size_t>(j) * columns_ + i; }

  double bin_;
  Vec3 low_;
  int columns_ = 0, rows_ = 0;
  std::vector<std::vector<Vec3>> bins_;
};

struct Probe {
  double gouge_mm = 0;  ///< deepest below the allowance surface
  Vec3 where;           ///< tip there
};

/// Looks at every `stride`th move, in steps of at most `spacing_mm`.
inline Probe probe(const model::Toolpath& path, const model::Cutter& cutter, double allowance_mm,
                   const PointBins& surface, double spacing_mm, std::size_t stride = 1) {
  Probe worst;
  for (std::size_t i = 0; i < path.moves.size(); i += stride) {
    const Vec3 a = model::move_from(path, i), b = path.moves[i].to;
    const int steps = 1 + static_cast<int>(distance(a, b) / spacing_mm);
    for (int k = 0; k <= steps; ++k) {
      const Vec3 tip = lerp(a, b, static_cast<double>(k) / steps);
      const double gouge =
          allowance_mm - surface.nearest(cutter, tip, cutter.radius_mm() + allowance_mm);
      if (gouge > worst.gouge_mm) worst = {gouge, tip};
    }
  }
  return worst;
}

}  // namespace limitgauge::test
