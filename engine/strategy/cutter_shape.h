#pragma once

#include <vector>

#include "engine/model/cutter.h"

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
  double height(double d) const;
  /// p'(d); infinite where the side is upright.
  double slope(double d) const;
  /// The greatest distance, up to the reach, at which the lower side is no higher than `height_mm`
  /// above the tip; negative where it is higher everywhere.
  double distance_below(double height_mm) const;
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
