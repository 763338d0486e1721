#pragma once

#include <algorithm>
#include <cmath>

#include "model/part/cutter.h"

namespace limitgauge::simulator {

/// Signed distance in the meridian half-plane (ρ, z) and its gradient there.
struct MeridianSample {
  double distance = 0;  ///< mm, negative inside
  double g_rho = 0, g_z = 0;
};

/// The fluted part of a cutter as a convex solid of revolution about +Z, tip at the origin: a
/// bottom that is level or rises from the tip, a corner arc tangent to it, a side tangent to the
/// arc, upright or leaning outwards or inwards, and a flat top at the flute length. Every cutter
/// type is a case of it: a flat has no arc, a ball no bottom.
class CutterProfile {
 public:
  /// Throws std::invalid_argument for a cutter that model::require_valid refuses.
  explicit CutterProfile(const model::Cutter& cutter);
  /// An upright cylinder with its base at the origin.
  CutterProfile(double radius_mm, double length_mm);

  /// Exact signed distance at radius `rho` >= 0 and height `z`, with a (sub)gradient.
  MeridianSample sample(double rho, double z) const {
    return is_flat() ? flat_sample(rho, z) : any_sample(rho, z);
  }
  /// Radius of a ball that lies inside the profile and touches it where `sample` was taken from
  /// (0 where there is none). With it the distance at p + δ is at most
  /// distance + g·δ + |δ|² / (2 (distance + radius)).
  double inscribed_radius(double rho, double z) const;
  /// True where the distance is −z for every point within `reach` of (rho, z): over a level bottom.
  bool flat_below(double rho, double z, double reach) const;
  /// True where what the profile sweeps is a plain cylinder of the largest radius at all heights
  /// from `z_low` to `z_high`, the profile going down by `below_mm` and up by `above_mm` from here.
  /// A side that leans outwards has that radius at its top alone.
  bool upright_between(double z_low, double z_high, double below_mm, double above_mm) const;
  /// A lower bound of the distance for every radius >= rho and every height in [z_low, z_high].
  double lower_bound(double rho, double z_low, double z_high) const {
    // The cutter stands inside a wider one without taper and with its corner lower, whose distance
    // falls with z up to its top, and over its bottom's cone; the top is a half-space of its own.
    const double x = rho - outer_disc_, below = outer_corner_z_ - z_high;
    const double nose = x > 0 && below > 0 ? std::sqrt(x * x + below * below) : std::max(x, below);
    const double bottom = rho * bottom_sin_ - z_high * bottom_cos_;
    return std::max({nose - corner_, bottom, z_low - length_});
  }

  /// How far the profile reaches in the direction (n_rho >= 0, n_z): the greatest n·(ρ, z) in it.
  double extent(double n_rho, double n_z) const;

  /// Height of the lowest point of the profile at radius `rho`; infinite beyond the largest radius.
  double nose_height(double rho) const;

  /// Distance of the corner arc's centre from the axis: the radius of a level bottom. A corner
  /// larger than the cutter is wide has its centre beyond the axis.
  double disc_radius() const { return disc_; }
  double corner_radius() const { return corner_; }
  double length() const { return length_; }
  /// A place on the axis about which a turn moves what cuts least: the height of the corner arc's
  /// centre, of a ball its own.
  double core_height() const { return std::clamp(corner_z_, 0.0, length_); }
  double largest_radius() const { return largest_radius_; }
  /// A hemisphere and a cylinder.
  bool is_ball() const { return disc_ == 0 && sin_ == 0 && bottom_sin_ == 0; }
  /// A plain cylinder.
  bool is_flat() const { return corner_ == 0 && sin_ == 0 && bottom_sin_ == 0; }

 private:
  void finish();
  MeridianSample any_sample(double rho, double z) const;
  MeridianSample flat_sample(double rho, double z) const;
  /// Outward distance from the line of the side, and from that of the bottom.
  double beyond_side(double rho, double z) const {
    return (rho - disc_) * cos_ - (z - corner_z_) * sin_ - corner_;
  }
  double below_bottom(double rho, double z) const { return rho * bottom_sin_ - z * bottom_cos_; }

  static MeridianSample from_point(double x, double z) {
    const double r = std::sqrt(x * x + z * z);
    return {r, x / r, z / r};
  }

  double disc_ = 0, corner_ = 0, corner_z_ = 0, length_ = 0;
  double sin_ = 0, cos_ = 1;                ///< of the side's angle from the axis
  double bottom_sin_ = 0, bottom_cos_ = 1;  ///< of the bottom's angle from level
  double side_z_ = 0;                       ///< where the arc ends and the side begins
  double top_radius_ = 0, largest_radius_ = 0;
  double outer_disc_ = 0, outer_corner_z_ = 0;
};

// What any_sample comes to, to the last bit, where neither sine nor arc has anything to add: tens
// of millions of moves of a rough stage are asked.
inline MeridianSample CutterProfile::flat_sample(double rho, double z) const {
  const double beside = rho - disc_, over = z - length_;
  if (beside > 0 && over > 0) return from_point(beside, over);
  if (beside > 0 && z < 0) return from_point(beside, z);
  const double below = 0.0 - z;
  const MeridianSample s =
      below >= beside ? MeridianSample{below, 0, -1} : MeridianSample{beside, 1, -sin_};
  return over > s.distance ? MeridianSample{over, 0, 1} : s;
}

}  // namespace limitgauge::simulator
