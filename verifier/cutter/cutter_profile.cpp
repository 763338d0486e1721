#include "verifier/cutter/cutter_profile.h"

#include <algorithm>
#include <cmath>

#include "model/base/angle.h"
#include "model/part/cutter.h"

namespace limitgauge::verifier {
namespace {

/// Distance to the core's edge.
ProfileDistance from_edge(const CutterProfile& profile, double beyond, double h) {
  const double edge = std::sqrt(beyond * beyond + h * h);
  return {edge - profile.rounding_mm, beyond / edge, h / edge};
}

/// The profile without its top, its side at `slope` going on for ever.
ProfileDistance wedge_distance(const CutterProfile& profile, double slope, double rho_mm,
                               double height_mm) {
  const double h = height_mm - profile.core_mm, beyond = rho_mm - profile.flat_mm;
  if (slope == 0 && profile.rise == 0) {
    if (h < 0 && beyond > 0) return from_edge(profile, beyond, h);
    if (beyond >= -h) return {beyond - profile.rounding_mm, 1, -slope};
    return {-h - profile.rounding_mm, 0, -1};
  }
  const double steep = std::sqrt(1 + slope * slope);
  const double shallow = std::sqrt(1 + profile.rise * profile.rise);
  if (profile.is_pointed()) {
    const double over_tip = height_mm - profile.tip_mm();
    if (rho_mm + over_tip * profile.rise < 0) {
      const double tip = std::sqrt(rho_mm * rho_mm + over_tip * over_tip);
      return {tip, rho_mm / tip, over_tip / tip};
    }
  }
  // The core is a convex wedge with its corner at (flat, core): floor below, wall to the side.
  const double along_wall = beyond * slope + h, along_floor = beyond + h * profile.rise;
  if (along_wall < 0 && along_floor > 0) return from_edge(profile, beyond, h);
  const double wall = (beyond - h * slope) / steep;
  const double floor = (beyond * profile.rise - h) / shallow;
  if (wall >= floor) return {wall - profile.rounding_mm, 1 / steep, -slope / steep};
  return {floor - profile.rounding_mm, profile.rise / shallow, -1 / shallow};
}

}  // namespace

CutterProfile::CutterProfile(const model::Cutter& cutter) {
  const model::SevenFigures figures = model::seven_figures(cutter);
  rounding_mm = figures.corner_radius;
  core_mm = figures.centre_height;
  top_mm = figures.height;
  if (figures.lower_angle != 0) rise = std::tan(model::radians(figures.lower_angle));
  if (figures.upper_angle != 0) slope = std::tan(model::radians(figures.upper_angle));
  // The corner begins no further in than at the axis, but for rounding of the figures.
  flat_mm = std::max(figures.centre_radius, -rounding_mm * rise / std::sqrt(1 + rise * rise));
}

CutterProfile::CutterProfile(const model::CylinderPart& part)
    : flat_mm(part.diameter_mm / 2), top_mm(part.length_mm) {}

double CutterProfile::tip_mm() const {
  return core_mm - flat_mm * rise - rounding_mm * std::sqrt(1 + rise * rise);
}

double CutterProfile::top_radius_mm() const {
  return std::max(
      0.0, flat_mm + (top_mm - core_mm) * slope + rounding_mm * std::sqrt(1 + slope * slope));
}

double CutterProfile::largest_radius_mm() const {
  return undercuts() ? flat_mm + rounding_mm : top_radius_mm();
}

ProfileDistance open_distance(const CutterProfile& profile, double rho_mm, double height_mm) {
  if (profile.is_ball()) {
    const double h = height_mm - profile.core_mm, beyond = rho_mm - profile.flat_mm;
    if (h >= 0) return {beyond - profile.rounding_mm, 1, 0};
    return from_edge(profile, beyond, h);
  }
  return wedge_distance(profile, profile.endless_slope(), rho_mm, height_mm);
}

ProfileDistance closed_distance(const CutterProfile& profile, double rho_mm, double height_mm) {
  const ProfileDistance open = profile.undercuts()
                                   ? wedge_distance(profile, profile.slope, rho_mm, height_mm)
                                   : open_distance(profile, rho_mm, height_mm);
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
