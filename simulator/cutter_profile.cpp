#include "simulator/cutter_profile.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace limitgauge::simulator {
namespace {

// The profile below its top is a wedge, offset by the corner radius. The wedge has its vertex at
// the arc's centre, one side level and one along the wall. (x, z) is relative to the vertex.
MeridianSample wedge(double x, double z, double sin_a, double cos_a) {
  const double along_wall = x * sin_a + z * cos_a;
  if (x > 0 && along_wall < 0) {
    const double r = std::sqrt(x * x + z * z);
    return {r, x / r, z / r};
  }
  const double wall = x * cos_a - z * sin_a;
  if (-z >= wall) return {-z, 0, -1};
  return {wall, cos_a, -sin_a};
}

}  // namespace

CutterProfile::CutterProfile(const model::Cutter& cutter) {
  model::require_valid(cutter);
  const bool taper = cutter.type == model::CutterType::taper;
  const double angle = taper ? cutter.taper_angle_deg * std::numbers::pi / 180 : 0.0;
  switch (cutter.type) {
    case model::CutterType::flat:
      corner_ = 0;
      break;
    case model::CutterType::ball:
      corner_ = cutter.radius_mm();
      break;
    case model::CutterType::bull:
    case model::CutterType::drill:
    case model::CutterType::apt:
    case model::CutterType::taper:
      corner_ = cutter.corner_radius_mm;
      break;
  }
  disc_ = cutter.radius_mm() - corner_;
  length_ = cutter.flute_length_mm;
  sin_ = std::sin(angle);
  cos_ = std::cos(angle);
  // Where the wall, tangent to the arc at height r (1 − sin α), meets the top.
  top_radius_ = disc_ + corner_ * cos_ + (length_ - corner_ * (1 - sin_)) * sin_ / cos_;
}

CutterProfile::CutterProfile(double radius_mm, double length_mm)
    : disc_(radius_mm), length_(length_mm), top_radius_(radius_mm) {}

MeridianSample CutterProfile::sample(double rho, double z) const {
  const double x = rho - top_radius_, t = z - length_;
  if (x > 0 && x * sin_ + t * cos_ > 0) {
    const double r = std::sqrt(x * x + t * t);
    return {r, x / r, t / r};
  }
  MeridianSample s = wedge(rho - disc_, z - corner_, sin_, cos_);
  s.distance -= corner_;
  if (t > s.distance) return {t, 0, 1};
  return s;
}

double CutterProfile::inscribed_radius(double rho, double z) const {
  const MeridianSample s = sample(rho, z);
  if (s.g_z > 0) return 0;
  const double foot_z = z - s.distance * s.g_z;
  const double below_top = std::max(0.0, length_ - foot_z);
  if (s.g_rho == 0 && rho <= disc_) return std::min(corner_ + disc_ - rho, below_top / 2);
  const bool on_wall = foot_z >= corner_ * (1 - sin_) && s.g_rho > 0;
  const double above_arc = on_wall ? std::min(disc_, foot_z - corner_ * (1 - sin_)) : 0.0;
  return std::min(corner_ + above_arc, below_top / (1 + std::abs(s.g_z)));
}

bool CutterProfile::flat_below(double rho, double z, double reach) const {
  const double wall = (rho - disc_) * cos_ - (z - corner_) * sin_ - corner_;
  return rho + reach <= disc_ && -z - reach >= wall + reach && -z - reach >= z + reach - length_;
}

bool CutterProfile::upright_between(double z_low, double z_high) const {
  // A block may end where the wall does, and miss it by rounding.
  constexpr double kRounding = 1e-9;
  return sin_ == 0 && z_low >= corner_ - kRounding && z_high <= length_ + kRounding;
}

double CutterProfile::nose_height(double rho) const {
  if (rho <= disc_) return 0;
  if (rho > top_radius_) return std::numeric_limits<double>::infinity();
  const double x = rho - disc_;
  if (x <= corner_ * cos_) return corner_ - std::sqrt(corner_ * corner_ - x * x);
  if (sin_ == 0) return corner_;
  return corner_ * (1 - sin_) + (x - corner_ * cos_) * cos_ / sin_;
}

}  // namespace limitgauge::simulator
