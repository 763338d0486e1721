#pragma once

#include <cmath>
#include <limits>

#include "model/part/cutter.h"

namespace limitgauge::tests::defects {

/// The underside of a cutter grown by `offset_mm` on all sides (shrunk where it is negative), over
/// the tip of the cutter itself: height as a function of the radius. Written from the definition in
/// model::Cutter; shares nothing with the libraries.
class Nose {
 public:
  Nose(const model::Cutter& cutter, double offset_mm) : lowered_(offset_mm) {
    using model::CutterType;
    constexpr double kDegree = 3.14159265358979323846 / 180;
    const double radius = cutter.diameter_mm / 2;
    const double corner = cutter.type == CutterType::flat   ? 0
                          : cutter.type == CutterType::ball ? radius
                                                            : cutter.corner_radius_mm;
    flat_ = radius - corner;
    // Shrunk by more than its corner, the cutter keeps a sharp edge, further in.
    corner_ = std::fmax(0, corner + offset_mm);
    flat_ = std::fmax(0, flat_ + std::fmin(0, corner + offset_mm));
    if (cutter.type == CutterType::taper) angle_ = cutter.taper_angle_deg * kDegree;
  }

  /// Infinite beyond the wall.
  double height(double rho) const {
    if (rho <= flat_) return -lowered_;
    const double x = rho - flat_, tangent = corner_ * std::cos(angle_);
    if (x <= tangent)
      return corner_ - std::sqrt(std::fmax(0, corner_ * corner_ - x * x)) - lowered_;
    if (angle_ == 0) return std::numeric_limits<double>::infinity();
    return corner_ * (1 - std::sin(angle_)) + (x - tangent) / std::tan(angle_) - lowered_;
  }
  /// Largest radius at which the nose is no higher than `height_mm` over its lowest point.
  double radius_below(double height_mm) const {
    const double tangent = flat_ + corner_ * std::cos(angle_);
    return tangent + (angle_ == 0 ? 0 : height_mm * std::tan(angle_));
  }
  /// Largest radius at which the nose has a height; none for a taper.
  double wall() const {
    return angle_ == 0 ? flat_ + corner_ : std::numeric_limits<double>::infinity();
  }
  double flat() const { return flat_; }
  double corner() const { return corner_; }
  /// Sine of the wall's inclination: a normal with a lower z cannot be touched.
  double wall_sine() const { return std::sin(angle_); }

 private:
  double flat_ = 0, corner_ = 0, lowered_ = 0, angle_ = 0;
};

}  // namespace limitgauge::tests::defects
