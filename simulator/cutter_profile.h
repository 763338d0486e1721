#pragma once

#include <algorithm>
#include <cmath>

#include "engine/model/cutter.h"

namespace limitgauge::simulator {

/// Signed distance in the meridian half-plane (ρ, z) and its gradient there.
struct MeridianSample {
  double distance = 0;  ///< mm, negative inside
  double g_rho = 0, g_z = 0;
};

/// The fluted part of a cutter as a convex solid of revolution about +Z, tip at the origin: a flat
/// disc, a corner arc tangent to it, a cylinder or cone tangent to the arc, and a flat top at the
/// flute length. Every cutter type is a case of it: a flat has no arc, a ball no disc.
class CutterProfile {
 public:
  /// Throws std::invalid_argument for a cutter that model::require_valid refuses.
  explicit CutterProfile(const model::Cutter& cutter);
  /// An upright cylinder with its base at the origin.
  CutterProfile(double radius_mm, double length_mm);

  /// Exact signed distance at radius `rho` >= 0 and height `z`, with a (sub)gradient.
  MeridianSample sample(double rho, double z) const;
  /// Radius of a ball that lies inside the profile and touches it where `sample` was taken from
  /// (0 where there is none). With it the distance at p + δ is at most
  /// distance + g·δ + |δ|² / (2 (distance + radius)).
  double inscribed_radius(double rho, double z) const;
  /// True where the distance is −z for every point within `reach` of (rho, z).
  bool flat_below(double rho, double z, double reach) const;
  /// True where the profile is a plain cylinder at all heights from `z_low` to `z_high`.
  bool upright_between(double z_low, double z_high) const;
  /// A lower bound of the distance for every radius >= rho and every height in [z_low, z_high].
  double lower_bound(double rho, double z_low, double z_high) const {
    // The cutter stands inside a wider one without taper, whose distance falls with z up to its
    // top; the top is a half-space of its own.
    const double x = rho - (top_radius_ - corner_), below = corner_ - z_high;
    const double nose = x > 0 && below > 0 ? std::sqrt(x * x + below * below) : std::max(x, below);
    return std::max(nose - corner_, z_low - length_);
  }

  /// Height of the lowest point of the profile at radius `rho`; infinite beyond the largest radius.
  double nose_height(double rho) const;

  double disc_radius() const { return disc_; }
  double corner_radius() const { return corner_; }
  double length() const { return length_; }
  double largest_radius() const { return top_radius_; }
  bool is_ball() const { return disc_ == 0 && sin_ == 0; }
  bool is_flat() const { return corner_ == 0 && sin_ == 0; }

 private:
  double disc_ = 0, corner_ = 0, length_ = 0;
  double sin_ = 0, cos_ = 1;  // of the taper's half angle
  double top_radius_ = 0;
};

}  // namespace limitgauge::simulator
