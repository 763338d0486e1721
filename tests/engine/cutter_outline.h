#pragma once
// A cutter's outline by sampling: an evaluator that knows nothing of discs or offsets.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "engine/model/cutter.h"

namespace limitgauge::test {

/// The fluted part of a cutter, its widest part going on upwards for ever, as points of its outline
/// in the half plane (distance from the axis, height above the tip).
class CutterOutline {
 public:
  /// Points lie no farther apart than twice this on the parts that matter.
  static constexpr double kError_mm = 0.01;

  explicit CutterOutline(const model::Cutter& c) {
    const double corner = c.type == model::CutterType::ball   ? c.radius_mm()
                          : c.type == model::CutterType::flat ? 0.0
                                                              : c.corner_radius_mm;
    const double cone =
        c.type == model::CutterType::taper ? c.taper_angle_deg * std::numbers::pi / 180 : 0.0;
    const double flat = c.radius_mm() - corner, end = std::numbers::pi / 2 - cone;
    widest_ = model::largest_radius_mm(c);
    add(0, 0, flat, 0);
    constexpr int kArcs = 400;
    for (int k = 0; k <= kArcs; ++k)
      points_.push_back(
          {flat + corner * std::sin(end * k / kArcs), corner - corner * std::cos(end * k / kArcs)});
    const Point foot = points_.back();
    if (cone > 0) add(foot.r, foot.h, widest_, foot.h + (widest_ - foot.r) / std::tan(cone));
    shaft_from_ = points_.back().h;
  }

  /// From the outline, for a place outside; minus it inside.
  double distance_mm(double r, double h) const {
    double least = h >= shaft_from_ ? std::abs(r - widest_) : 1e9, inside = -1;
    for (const Point& p : points_) {
      least = std::min(least, std::hypot(r - p.r, h - p.h));
      if (p.h <= h) inside = p.r;  // Radius at the highest point of the outline below.
    }
    return r < inside ? -least : least;
  }

 private:
  struct Point {
    double r = 0, h = 0;
  };

  void add(double r0, double h0, double r1, double h1) {
    const int steps = 1 + static_cast<int>(std::hypot(r1 - r0, h1 - h0) / kError_mm);
    for (int k = 0; k <= steps; ++k)
      points_.push_back({r0 + (r1 - r0) * k / steps, h0 + (h1 - h0) * k / steps});
  }

  double widest_ = 0, shaft_from_ = 0;
  std::vector<Point> points_;  ///< from the tip up
};

}  // namespace limitgauge::test
