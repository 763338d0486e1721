#include "verifier/cutter_profile.h"

#include <cmath>

#include "engine/model/angle.h"

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
    case model::CutterType::drill:
    case model::CutterType::apt:
    case model::CutterType::taper:
      rounding_mm = cutter.corner_radius_mm;
      flat_mm = radius - cutter.corner_radius_mm;
      break;
  }
  if (cutter.type == model::CutterType::taper)
    slope = std::tan(model::radians(cutter.taper_angle_deg));
}

CutterProfile::CutterProfile(const model::CylinderPart& part)
    : flat_mm(part.diameter_mm / 2), top_mm(part.length_mm) {}

double CutterProfile::top_radius_mm() const {
  return flat_mm + (top_mm - rounding_mm) * slope + rounding_mm * std::sqrt(1 + slope * slope);
}

ProfileDistance open_distance(const CutterProfile& profile, double rho_mm, double height_mm) {
  const double h = height_mm - profile.rounding_mm, beyond = rho_mm - profile.flat_mm;
  if (profile.is_ball()) {
    if (h >= 0) return {beyond - profile.rounding_mm, 1, 0};
    const double centre = std::sqrt(beyond * beyond + h * h);
    return {centre - profile.rounding_mm, beyond / centre, h / centre};
  }
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
  const double corner = std::sqrt(beyond * beyond + h * h);
  return {corner - profile.rounding_mm, beyond / corner, h / corner};
}

ProfileDistance closed_distance(const CutterProfile& profile, double rho_mm, double height_mm) {
  const ProfileDistance open = open_distance(profile, rho_mm, height_mm);
  const double over = height_mm - profile.top_mm;
  if (open.value <= 0 && over <= 0) return over > open.value ? ProfileDistance{over, 0, 1} : open;
  const double beside = rho_mm - profile.top_radius_mm();
  if (beside <= 0) return over > open.value ? ProfileDistance{over, 0, 1} : open;
  // Beyond the rim of the top: the wall is nearest unless its nearest point lies over the top.
  if (beside * profile.slope + over <= 0) return open;
  const double rim = std::sqrt(beside * beside + over * over);
  return {rim, beside / rim, over / rim};
}

}  // namespace limitgauge::verifier
