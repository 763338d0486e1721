#pragma once
// A cutter's outline piece by piece: an evaluator that knows nothing of discs or offsets.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "model/part/cutter.h"

namespace limitgauge::test {

/// The fluted part of a cutter, its widest part going on upwards for ever: the flat, the rounding,
/// the cone and the shaft of its outline in the half plane (distance from the axis, height above
/// the tip), each for itself.
class CutterOutline {
 public:
  explicit CutterOutline(const model::Cutter& c) {
    corner_ = c.type == model::CutterType::ball   ? c.radius_mm()
              : c.type == model::CutterType::flat ? 0.0
                                                  : c.corner_radius_mm;
    const double cone =
        c.type == model::CutterType::taper ? c.taper_angle_deg * std::numbers::pi / 180 : 0.0;
    flat_ = c.radius_mm() - corner_;
    turn_ = std::numbers::pi / 2 - cone;
    foot_ = {flat_ + corner_ * std::sin(turn_), corner_ - corner_ * std::cos(turn_)};
    top_ = foot_;
    if (cone > 0) {
      const double widest = model::largest_radius_mm(c);
      top_ = {widest, foot_.h + (widest - foot_.r) / std::tan(cone)};
    }
  }

  /// From the outline, for a place outside; minus it inside.
  double distance_mm(double r, double h) const {
    double least = to_segment({r, h}, {0, 0}, {flat_, 0});
    least = std::min(least, to_segment({r, h}, foot_, top_));
    least =
        std::min(least, h >= top_.h ? std::abs(r - top_.r) : std::hypot(r - top_.r, h - top_.h));
    const double angle = std::atan2(r - flat_, corner_ - h);
    if (angle >= 0 && angle <= turn_)
      least = std::min(least, std::abs(std::hypot(r - flat_, h - corner_) - corner_));
    return r < radius_at(h) ? -least : least;
  }

 private:
  struct Point {
    double r = 0, h = 0;
  };

  static double to_segment(const Point& p, const Point& a, const Point& b) {
    const double dr = b.r - a.r, dh = b.h - a.h, l2 = dr * dr + dh * dh;
    const double t =
        l2 > 0 ? std::clamp(((p.r - a.r) * dr + (p.h - a.h) * dh) / l2, 0.0, 1.0) : 0.0;
    return std::hypot(p.r - a.r - t * dr, p.h - a.h - t * dh);
  }
  double radius_at(double h) const {
    if (h < 0) return -1;
    if (h >= top_.h) return top_.r;
    if (h >= foot_.h) return foot_.r + (top_.r - foot_.r) * (h - foot_.h) / (top_.h - foot_.h);
    return flat_ + std::sqrt(corner_ * corner_ - (corner_ - h) * (corner_ - h));
  }

  double flat_ = 0, corner_ = 0, turn_ = 0;
  Point foot_, top_;
};

}  // namespace limitgauge::test
