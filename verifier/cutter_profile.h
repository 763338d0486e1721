#pragma once

#include "engine/model/cutter.h"

namespace limitgauge::verifier {

/// The fluted part of a cutter as a rounded core: all points within `rounding` of the core, which
/// is the solid of revolution {ρ ≤ flat + h·slope, h ≥ 0} above the height `rounding` over the tip,
/// open upwards; cut off flat at the flute length. Flat, ball, bull and taper are all of this form:
///   flat:  rounding 0,  flat R, slope 0      ball:  rounding R, flat 0,     slope 0
///   bull:  rounding r,  flat R − r, slope 0  taper: rounding r, flat D/2 − r, slope tan(angle)
/// (A taper's corner arc is tangent to the cone: the offset by r of a cone core.) A part of a shank
/// or holder is a flat cutter as long as the part.
struct CutterProfile {
  double rounding_mm = 0;
  double flat_mm = 0;
  double slope = 0;
  double top_mm = 0;  ///< flute length, or length of the part

  explicit CutterProfile(const model::Cutter& cutter);
  explicit CutterProfile(const model::CylinderPart& part);

  bool is_ball() const { return flat_mm <= 0 && slope == 0; }
  /// Radius of the wall at the top.
  double top_radius_mm() const;
};

/// Signed distance and its derivative at one point of the (ρ, height over tip) half plane.
struct ProfileDistance {
  double value = 0;
  double by_rho = 0, by_height = 0;  ///< a unit gradient where value is smooth
};

/// Signed distance to the profile without its flat top: negative inside. Convex in (ρ, h),
/// non-decreasing in ρ, non-increasing in h: the body only widens upwards.
ProfileDistance open_distance(const CutterProfile& profile, double rho_mm, double height_mm);

/// Signed distance to the profile with its flat top, which is convex too: exact outside, the depth
/// below the nearest side inside.
ProfileDistance closed_distance(const CutterProfile& profile, double rho_mm, double height_mm);

}  // namespace limitgauge::verifier
