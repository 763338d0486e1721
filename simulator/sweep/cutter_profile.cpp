#include "simulator/sweep/cutter_profile.h"

#include <limits>

#include "model/base/angle.h"
#include "simulator/tolerance.h"

namespace limitgauge::simulator {
namespace {

using model::radians;

}  // namespace

CutterProfile::CutterProfile(const model::Cutter& cutter) {
  model::require_valid(cutter);
  const model::SevenFigures figures = model::seven_figures(cutter);
  corner_ = figures.corner_radius;
  length_ = figures.height;
  sin_ = std::sin(radians(figures.upper_angle));
  cos_ = std::cos(radians(figures.upper_angle));
  bottom_sin_ = std::sin(radians(figures.lower_angle));
  bottom_cos_ = std::cos(radians(figures.lower_angle));
  // A valid centre may miss the place where the arc begins on the axis by rounding.
  disc_ = std::max(figures.centre_radius, -corner_ * bottom_sin_);
  corner_z_ = figures.centre_height;
  finish();
}

CutterProfile::CutterProfile(double radius_mm, double length_mm)
    : disc_(radius_mm), length_(length_mm) {
  finish();
}

void CutterProfile::finish() {
  side_z_ = corner_z_ - corner_ * sin_;
  // Where the side, tangent to the arc, meets the top.
  top_radius_ = std::max(0.0, disc_ + corner_ * cos_ + (length_ - side_z_) * sin_ / cos_);
  largest_radius_ = sin_ > 0 ? top_radius_ : disc_ + corner_;
  outer_disc_ = std::max({disc_, largest_radius_ - corner_, 0.0});
  outer_corner_z_ = std::min(corner_z_, corner_);
}

MeridianSample CutterProfile::any_sample(double rho, double z) const {
  const double beside = rho - top_radius_, over = z - length_;
  // Beyond the rim of the top, between the normals of side and top.
  if (beside > 0 && beside * sin_ + over * cos_ > 0) return from_point(beside, over);
  // Under the tip, among the normals of its point.
  if (rho * bottom_cos_ + z * bottom_sin_ < 0) return from_point(rho, z);
  const double x = rho - disc_, y = z - corner_z_;
  MeridianSample s;
  if (x * bottom_cos_ + y * bottom_sin_ > 0 && x * sin_ + y * cos_ < 0) {
    s = from_point(x, y);
    s.distance -= corner_;
  } else {
    const double bottom = below_bottom(rho, z), side = beyond_side(rho, z);
    s = bottom >= side ? MeridianSample{bottom, bottom_sin_, -bottom_cos_}
                       : MeridianSample{side, cos_, -sin_};
  }
  return over > s.distance ? MeridianSample{over, 0, 1} : s;
}

// A ball that touches from inside with outward normal n at the foot keeps to the half-space of
// another outward normal m while its radius is at most the foot's depth there over 1 − m·n.
double CutterProfile::inscribed_radius(double rho, double z) const {
  const MeridianSample s = sample(rho, z);
  const bool on_top = s.g_z > std::max(0.0, -sin_);
  const bool on_tip = bottom_sin_ > 0 && s.g_z < -bottom_cos_;
  if (on_top || on_tip) return 0;
  const double foot_rho = rho - s.distance * s.g_rho, foot_z = z - s.distance * s.g_z;
  double radius = (length_ - foot_z) / (1 - s.g_z);
  // Across the meridian the profile bends about the axis.
  if (s.g_rho > 0) radius = std::min(radius, foot_rho / s.g_rho);
  const double apart = 1 - bottom_sin_ * cos_ - bottom_cos_ * sin_;
  if (s.g_rho == bottom_sin_ && s.g_z == -bottom_cos_)
    radius = std::min(radius, -beyond_side(foot_rho, foot_z) / apart);
  else if (s.g_rho == cos_ && s.g_z == -sin_)
    radius = std::min(radius, -below_bottom(foot_rho, foot_z) / apart);
  else
    radius = std::min(radius, corner_);
  return std::max(0.0, radius);
}

bool CutterProfile::flat_below(double rho, double z, double reach) const {
  const double side = beyond_side(rho, z);
  return bottom_sin_ == 0 && rho + reach <= disc_ && -z - reach >= side + reach &&
         -z - reach >= z + reach - length_;
}

bool CutterProfile::upright_between(double z_low, double z_high, double below_mm,
                                    double above_mm) const {
  const double widest_from = sin_ == 0 ? side_z_ : length_;
  return sin_ >= 0 && z_low >= widest_from - below_mm - kDistanceRounding_mm &&
         z_high <= length_ + above_mm + kDistanceRounding_mm;
}

// The hull of its tip, the rim of its top, and the arc, of which the ends, or the place whose
// normal is n, reach farthest.
double CutterProfile::extent(double n_rho, double n_z) const {
  const double n = std::sqrt(n_rho * n_rho + n_z * n_z);
  const bool above_bottom = n_rho * bottom_cos_ + n_z * bottom_sin_ >= 0;
  const bool below_side = n_rho * sin_ + n_z * cos_ <= 0;
  const double centre = n_rho * disc_ + n_z * corner_z_;
  const double at_ends =
      std::max(n_rho * bottom_sin_ - n_z * bottom_cos_, n_rho * cos_ - n_z * sin_);
  const double arc = centre + corner_ * (above_bottom && below_side ? n : at_ends);
  return std::max({0.0, n_z * length_, n_rho * top_radius_ + n_z * length_, arc});
}

double CutterProfile::nose_height(double rho) const {
  if (rho > largest_radius_) return std::numeric_limits<double>::infinity();
  if (rho <= disc_ + corner_ * bottom_sin_) return rho * bottom_sin_ / bottom_cos_;
  const double x = rho - disc_;
  const double arc_ends = sin_ > 0 ? corner_ * cos_ : corner_;
  if (x <= arc_ends) return corner_z_ - std::sqrt(corner_ * corner_ - x * x);
  if (sin_ <= 0) return corner_z_;
  return side_z_ + (x - arc_ends) * cos_ / sin_;
}

}  // namespace limitgauge::simulator
