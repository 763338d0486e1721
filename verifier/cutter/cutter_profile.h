#pragma once

#include <algorithm>
#include <cmath>

#include "model/part/cutter.h"

namespace limitgauge::verifier {

/// The fluted part of a cutter as a rounded core, cut off flat at the flute length: all points
/// within `rounding` of the solid of revolution
///   {h ≥ core + (ρ − flat)·rise,  ρ ≤ flat + (h − core)·slope}
/// over the tip at h = 0, with the bottom's rounded-off point at the axis filled up to the tip
/// where the bottom rises. Every cutter is of this form:
///   flat:  rounding 0, flat R            bull: rounding r, flat R − r, core r
///   ball:  rounding R, flat 0, core R    taper: as bull of its tip, slope tan(angle)
///   drill: rounding 0, flat R, core R·rise, rise tan(tip angle)
///   apt:   any rise, and a slope that may be negative: a side that leans inwards
/// (A corner arc is tangent to both its lines: the offset by r of the core's edge.) A part of a
/// shank or holder is a flat cutter as long as the part.
struct CutterProfile {
  double rounding_mm = 0;
  double flat_mm = 0;  ///< of the core's edge; negative where the corner is wider than the cutter
  double core_mm = 0;  ///< height of the core's edge over the tip
  double rise = 0;     ///< of the bottom, per radius
  double slope = 0;    ///< of the side, per height
  double top_mm = 0;   ///< flute length, or length of the part

  explicit CutterProfile(const model::Cutter& cutter);
  explicit CutterProfile(const model::CylinderPart& part);

  bool is_ball() const { return flat_mm <= 0 && slope == 0 && rise == 0; }
  /// A ball whose flutes hold all of it: below the core nothing else is nearer.
  bool is_whole_ball() const { return is_ball() && top_mm >= core_mm + rounding_mm; }
  /// The bottom rises from a sharp tip.
  bool is_pointed() const { return rise > 0; }
  /// The side leans inwards: the cutter can stand under a place of S.
  bool undercuts() const { return slope < 0; }
  /// Height of the tip: 0, but for a profile whose flat was changed.
  double tip_mm() const;
  /// Radius of the side at the top, and greatest radius below it.
  double top_radius_mm() const;
  double largest_radius_mm() const;
  /// Slope of the side of the endless cutter: upright instead of inwards.
  double endless_slope() const { return slope > 0 ? slope : 0; }
  /// Greatest g·x over the endless cutter with its tip at the origin, for a unit vector g that has
  /// `level` in plan and `up` upwards, turned down as far as the side has a plane: up is no more
  /// than −level·slope. Of a bottom that does not rise and a flat of no less than nothing.
  double extent_mm(double level, double up) const {
    return flat_mm * level + core_mm * up + rounding_mm;
  }
};

/// Signed distance and its derivative at one point of the (ρ, height over tip) half plane.
struct ProfileDistance {
  double value = 0;
  double by_rho = 0, by_height = 0;  ///< a unit gradient where value is smooth
};

/// Signed distance to the endless cutter, all that the profile sweeps on its way up: without the
/// flat top, the side going up without end, upright where it leans inwards. Negative inside. Convex
/// in (ρ, h), non-decreasing in ρ, non-increasing in h: the body only widens upwards. It holds the
/// profile, so this is never more than closed_distance, and below the top the same unless the
/// profile undercuts.
ProfileDistance open_distance(const CutterProfile& profile, double rho_mm, double height_mm);

/// Its value alone, for bounds: of the most usual cutters, upright and with a level or round
/// bottom, by few operations, the same to the last bit.
inline double open_value(const CutterProfile& profile, double rho_mm, double height_mm) {
  if (profile.endless_slope() != 0 || profile.rise != 0)
    return open_distance(profile, rho_mm, height_mm).value;
  const double h = height_mm - profile.core_mm, beyond = rho_mm - profile.flat_mm;
  if (h < 0 && (beyond > 0 || profile.is_ball()))
    return std::sqrt(beyond * beyond + h * h) - profile.rounding_mm;
  return (profile.is_ball() ? beyond : std::max(beyond, -h)) - profile.rounding_mm;
}

/// Signed distance to the profile with its flat top, which is convex too: exact outside, the depth
/// below the nearest side inside. Non-decreasing in ρ.
ProfileDistance closed_distance(const CutterProfile& profile, double rho_mm, double height_mm);

}  // namespace limitgauge::verifier
