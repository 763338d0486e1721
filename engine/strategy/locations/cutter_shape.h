#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "model/part/cutter.h"

namespace limitgauge::engine::strategy {

/// A convex solid of revolution about +Z, open upwards: one body of a cutter with its tip at the
/// origin, continued upwards and grown by an allowance. Its lower side is made of rounded rings
/// (the offset of a circle: an arc in the half plane of distance d and height z) and of the common
/// tangents between them; inside the first ring it is flat, outside the last it is a cylinder.
///
///   flat, bull, ball and parts of shank and holder: one ring; taper: the rounding of the tip, the
///   cone, and the ring where the flutes end, where the widest radius goes on upwards.
class CutterShape {
 public:
  struct Ring {
    double radius_mm = 0;    ///< of the circle
    double height_mm = 0;    ///< of the circle above the tip
    double rounding_mm = 0;  ///< by which the circle is grown

    /// Lower side of the grown disc at distance `d`, its slope and its inverse.
    double height_at(double d) const {
      const double out = std::max(0.0, d - radius_mm);
      return height_mm - std::sqrt(std::max(0.0, (rounding_mm - out) * (rounding_mm + out)));
    }
    double slope_at(double d) const {
      const double out = d - radius_mm;
      if (out <= 0) return 0;
      if (out >= rounding_mm) return std::numeric_limits<double>::infinity();
      return out / std::sqrt((rounding_mm - out) * (rounding_mm + out));
    }
    double distance_at(double z) const {
      const double up = std::min(0.0, z - height_mm);
      return radius_mm + std::sqrt(std::max(0.0, (rounding_mm - up) * (rounding_mm + up)));
    }
  };
  /// Place and slope of the arc of one ring: from d = begin_mm to d = end_mm.
  struct Arc {
    Ring ring;
    double begin_mm = 0, end_mm = 0;
  };

  /// The fluted part.
  CutterShape(const model::Cutter& cutter, double allowance_mm);
  /// A cylinder that begins at `height_mm` above the tip.
  CutterShape(const model::CylinderPart& part, double height_mm, double allowance_mm);

  /// Half the width of the body, mm.
  double reach_mm() const { return reach_mm_; }
  double flat_mm() const { return first_.ring.radius_mm; }
  double bottom_mm() const { return first_.ring.height_mm - first_.ring.rounding_mm; }
  bool has_cone() const { return coned_; }
  const Arc& first() const { return first_; }
  const Arc& last() const { return last_; }
  double cone_slope() const { return cone_slope_; }

  /// Height p(d) of the lower side above the tip at distance `d` from the axis: convex, not
  /// falling. Beyond the reach it is that at the reach: ask only within.
  double height(double d) const {
    if (d <= first_.end_mm || !coned_) return first_.ring.height_at(d);
    if (d <= last_.begin_mm) return cone_z_mm_ + (d - first_.end_mm) * cone_slope_;
    return last_.ring.height_at(d);
  }
  /// p'(d); infinite where the side is upright.
  double slope(double d) const {
    if (d <= first_.end_mm || !coned_) return first_.ring.slope_at(d);
    return d <= last_.begin_mm ? cone_slope_ : last_.ring.slope_at(d);
  }
  /// The greatest distance, up to the reach, at which the lower side is no higher than `height_mm`
  /// above the tip; negative where it is higher everywhere.
  double distance_below(double height_mm) const {
    if (height_mm < bottom_mm()) return -1;
    if (!coned_ || height_mm <= cone_z_mm_) return first_.ring.distance_at(height_mm);
    const double d = first_.end_mm + (height_mm - cone_z_mm_) / cone_slope_;
    return d <= last_.begin_mm ? d : last_.ring.distance_at(height_mm);
  }
  /// How high over the plane z + g . (x, y) = c a tip on it must be lifted so that the body only
  /// touches the plane; `steepness` is |g|.
  double support(double steepness) const;
  /// Distance from the axis at which the body touches a plane of that steepness.
  double contact_distance(double steepness) const;

 private:
  void finish_single();

  Arc first_, last_;
  bool coned_ = false;
  double cone_slope_ = 0, cone_steepness_ = 0, cone_z_mm_ = 0;
  double reach_mm_ = 0;
};

/// The bodies of a cutter grown by `allowance_mm`: the fluted part, and with `with_assembly` every
/// part of shank and holder that is wider than all below it (others hide behind those).
std::vector<CutterShape> cutter_shapes(const model::Cutter& cutter, double allowance_mm,
                                       bool with_assembly);

}  // namespace limitgauge::engine::strategy
