#include "verifier/reach/cell_contact.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace limitgauge::verifier {
namespace {

using model::Vec3;
using std::numbers::pi;

constexpr double kWidestCone = 1.2;  // radians: beyond, nothing is ever proven

}  // namespace

std::optional<CellContact> CellContact::of(const OffsetCell& cell, const CutterProfile& profile,
                                           double allowance_mm) {
  if (profile.is_pointed() || profile.undercuts()) return std::nullopt;
  if (cell.spread_rad > kWidestCone) return std::nullopt;
  CellContact c(cell, profile);
  const Vec3& n = cell.normal;
  c.radius_ = control_radius(cell.shape, cell.middle);
  c.reach_ = profile.rounding_mm + allowance_mm;
  c.steepest_ = pi / 2 - std::atan(profile.slope);
  c.tilt_ = std::atan2(std::hypot(n.x, n.y), n.z);
  c.alpha_ = cell.spread_rad;
  // A wall that leans over by less than kContactTurn_rad is touched along the cutter's own wall:
  // with the normal turned by so much the contact plane stays one.
  const double over = c.tilt_ + c.alpha_ - c.steepest_;
  if (over > 0 && over <= kContactTurn_rad) c.alpha_ += over;

  const double level = std::hypot(n.x, n.y);
  c.direction_ = level > 0 ? Vec3{n.x / level, n.y / level, 0} : Vec3{1, 0, 0};
  c.tip_ = cell.moved_middle(c.reach_) - Vec3{0, 0, profile.rounding_mm};
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
  c.turn_by_alpha_ = {std::sin(c.alpha_), 1 - std::cos(c.alpha_)};
  c.turn_by_beta_ = {std::sin(c.beta_), 1 - std::cos(c.beta_)};
  c.lowest_along_ = control_range(cell.shape, 0, n).low;
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
  return control_range(cell_.shape, 0, g).high - dot(g, middle()) + turning_shift(g);
}

double CellContact::turning_shift(const Vec3& g) const {
  const double by_normal = dot(g, normal());
  const double across = length(g - normal() * by_normal);
  double shift =
      reach_ * (turn_by_alpha_.x * across + turn_by_alpha_.y * std::max(0.0, -by_normal));
  if (flat_ > 0) {
    const double aside = std::abs(g.y * direction_.x - g.x * direction_.y);
    const double back = std::max(0.0, -dot(g, direction_));
    shift += flat_ * (turn_by_beta_.x * aside + turn_by_beta_.y * back);
  }
  return shift;
}

double CellContact::over_contact_plane(double along_normal, double apart) const {
  const double rise = along_normal - lowest_along_;
  return (rise > 0 ? rise : rise * (1 - turn_by_alpha_.y)) + turn_by_alpha_.x * (apart + radius_);
}

bool CellContact::clears_itself(double tolerance_mm) const {
  return over_contact_plane(control_range(cell_.shape, 0, normal()).high, radius_) <= tolerance_mm;
}

}  // namespace limitgauge::verifier
