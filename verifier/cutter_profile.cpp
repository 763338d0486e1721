#include "verifier/cutter_profile.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace limitgauge::verifier {

CutterProfile::CutterProfile(const model::Cutter& cutter) : top_mm(cutter.flute_length_mm) {
  const double radius = cutter.radius_mm();
  switch (cutter.type) {
    case model::CutterType::flat:
      flat_mm = radius;
      break;
    case model::CutterType::ball:
      rounding_mm = radius;
      break;
    case model::CutterType::bull:
    case model::CutterType::taper:
      rounding_mm = cutter.corner_radius_mm;
      flat_mm = radius - cutter.corner_radius_mm;
      break;
  }
  if (cutter.type == model::CutterType::taper)
    slope = std::tan(cutter.taper_angle_deg * std::numbers::pi / 180);
}

ProfileDistance open_distance(const CutterProfile& profile, double rho_mm, double height_mm) {
  const double h = height_mm - profile.rounding_mm, beyond = rho_mm - profile.flat_mm;
  // The core is a convex wedge with its corner at (flat, 0): floor below, wall to the side.
  const double steep = std::sqrt(1 + profile.slope * profile.slope);
  const double along = (beyond * profile.slope + h) / steep;  // up the wall from the corner
  const double wall = (beyond - h * profile.slope) / steep;
  const double floor = -h;
  if (wall <= 0 && floor <= 0) {
    if (wall >= floor) return {wall - profile.rounding_mm, 1 / steep, -profile.slope / steep};
    return {floor - profile.rounding_mm, 0, -1};
  }
  if (beyond <= 0 && floor > 0) return {floor - profile.rounding_mm, 0, -1};
  if (along >= 0) return {wall - profile.rounding_mm, 1 / steep, -profile.slope / steep};
  const double corner = std::hypot(beyond, h);
  return {corner - profile.rounding_mm, beyond / corner, h / corner};
}

}  // namespace limitgauge::verifier
