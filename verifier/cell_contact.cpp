#include "verifier/cell_contact.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "verifier/swept_body.h"

namespace limitgauge::verifier {
namespace {

using model::Vec3;
using std::numbers::pi;

constexpr double kWidestCone = 1.2;  // radians: beyond, nothing is ever proven

struct Range {
  double low = 0, high = 0;
};
Range along(const Bezier& b, const Vec3& from, const Vec3& axis) {
  Range r{1e300, -1e300};
  for (int k = 0; k < 16; ++k) {
    const double at = dot(b.control(k) - from, axis);
    r.low = std::min(r.low, at), r.high = std::max(r.high, at);
  }
  return r;
}

}  // namespace

std::optional<CellContact> CellContact::of(const Bezier& cell, const CutterProfile& profile,
                                           double allowance_mm) {
  if (profile.is_pointed() || profile.undercuts()) return std::nullopt;
  const BezierJet at = jet(cell, 0.5, 0.5);
  const auto cone = normal_cone(cell, normalized(cross(at.du, at.dv)));
  if (!cone || cone->half_angle_rad > kWidestCone) return std::nullopt;
  CellContact c(cell, profile);
  c.middle_ = verifier::middle(cell);
  c.normal_ = cone->axis;
  c.radius_ = control_radius(cell, c.middle_);
  c.reach_ = profile.rounding_mm + allowance_mm;
  c.steepest_ = pi / 2 - std::atan(profile.slope);
  c.tilt_ = std::atan2(std::hypot(c.normal_.x, c.normal_.y), c.normal_.z);
  c.alpha_ = cone->half_angle_rad;
  // A wall that leans over by less than kAngle is touched along the cutter's own wall: with the
  // normal turned by so much the contact plane stays one.
  const double over = c.tilt_ + c.alpha_ - c.steepest_;
  if (over > 0 && over <= kAngle) c.alpha_ += over;

  const double level = std::hypot(c.normal_.x, c.normal_.y);
  c.direction_ = level > 0 ? Vec3{c.normal_.x / level, c.normal_.y / level, 0} : Vec3{1, 0, 0};
  c.tip_ = c.middle_ + c.normal_ * c.reach_ - Vec3{0, 0, profile.rounding_mm};
  c.stray_ = c.radius_ + c.reach_ * 2 * std::sin(c.alpha_ / 2);
  const double sine = c.tilt_ > c.alpha_ && level > 0 ? std::sin(c.alpha_) / level : 1;
  if (profile.flat_mm > 0 && sine > 0.9) {
    c.turning_ = true;
    c.profile_.flat_mm *= 2;
  } else if (profile.flat_mm > 0) {
    c.beta_ = std::asin(sine);
    c.flat_ = profile.flat_mm;
    c.tip_ += c.direction_ * c.flat_;
    c.stray_ += c.flat_ * 2 * std::sin(c.beta_ / 2);
  } else if (level > 0 && sine < 1) {
    c.beta_ = std::asin(sine);
  } else {
    c.beta_ = pi;
  }
  c.lowest_along_ = along(cell, {}, c.normal_).low;
  return c;
}

CellContact CellContact::displaced(const Vec3& shift) const {
  CellContact c = *this;
  if (c.turning_) c.profile_.flat_mm /= 2;
  c.turning_ = false;
  c.flat_ = 0;
  c.tip_ += shift;
  return c;
}

double CellContact::largest_shift(const Vec3& g) const {
  double linear = -1e300;
  for (int k = 0; k < 16; ++k)
    linear = std::max(linear, g.x * cell_.x[k] + g.y * cell_.y[k] + g.z * cell_.z[k]);
  const double by_normal = dot(g, normal_);
  const double across = length(g - normal_ * by_normal);
  double shift = linear - dot(g, middle_);
  shift +=
      reach_ * (std::sin(alpha_) * across + (1 - std::cos(alpha_)) * std::max(0.0, -by_normal));
  if (flat_ > 0) {
    const double aside = std::abs(g.y * direction_.x - g.x * direction_.y);
    const double back = std::max(0.0, -dot(g, direction_));
    shift += flat_ * (std::sin(beta_) * aside + (1 - std::cos(beta_)) * back);
  }
  return shift;
}

double CellContact::over_contact_plane(double along_normal, double apart) const {
  const double rise = along_normal - lowest_along_;
  return (rise > 0 ? rise : rise * std::cos(alpha_)) + std::sin(alpha_) * (apart + radius_);
}

bool CellContact::always_below(const Vec3& q, double limit_mm) const {
  if (turning_) return false;
  const Vec3 b{-direction_.y, direction_.x, 0}, t = cross(b, normal_);
  Range by_t = along(cell_, middle_, t), by_b = along(cell_, middle_, b),
        by_n = along(cell_, middle_, normal_);
  const double aside = reach_ * std::sin(alpha_);
  by_t.low -= aside, by_t.high += aside, by_b.low -= aside, by_b.high += aside;
  by_n.low -= reach_ * (1 - std::cos(alpha_));
  if (flat_ > 0) {
    by_b.low -= flat_ * std::sin(beta_), by_b.high += flat_ * std::sin(beta_);
    const double back = flat_ * (1 - std::cos(beta_));
    const double on_t = dot(direction_, t), on_n = dot(direction_, normal_);
    (on_t > 0 ? by_t.low : by_t.high) -= back * on_t;
    (on_n > 0 ? by_n.low : by_n.high) -= back * on_n;
  }
  for (int k = 0; k < 8; ++k) {
    const Vec3 tip = tip_ + t * (k & 1 ? by_t.low : by_t.high) +
                     b * (k & 2 ? by_b.low : by_b.high) + normal_ * (k & 4 ? by_n.low : by_n.high);
    if (standing_distance(profile_, tip, q).value >= limit_mm) return false;
  }
  return true;
}

}  // namespace limitgauge::verifier
