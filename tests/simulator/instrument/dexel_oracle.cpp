#include "tests/simulator/instrument/dexel_oracle.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace limitgauge::simulator::test {

using model::CutterType;
using model::Vec3;

DexelOracle::DexelOracle(const model::Cutter& c) {
  corner_ = c.type == CutterType::ball ? c.diameter_mm / 2 : c.corner_radius_mm;
  length_ = c.flute_length_mm;
  bottom_ = c.tip_angle_deg * std::numbers::pi / 180;
  lean_ = c.taper_angle_deg * std::numbers::pi / 180;
  const double q = c.diameter_mm / 2;
  vertex_ = {q - corner_, corner_};
  if (c.type == CutterType::apt || c.type == CutterType::drill) {
    // −ρ sin b + z cos b = r and (q − ρ) cos a + (z − q tan b) sin a = r, by Cramer's rule.
    const double sb = std::sin(bottom_), cb = std::cos(bottom_);
    const double sa = std::sin(lean_), ca = std::cos(lean_);
    const double right = corner_ - q * ca + q * sb / cb * sa;
    const double det = -sb * sa + cb * ca;
    vertex_ = {(corner_ * sa - cb * right) / det, (-sb * right + ca * corner_) / det};
  }
  // The widest place: at the top, or where the arc is upright.
  widest_ = lean_ > 0
                ? vertex_.rho + (length_ - vertex_.z) * std::tan(lean_) + corner_ / std::cos(lean_)
                : vertex_.rho + corner_;
}

double DexelOracle::over_bottom(const Point& p) const {
  return (p.z - vertex_.z) * std::cos(bottom_) - (p.rho - vertex_.rho) * std::sin(bottom_);
}
double DexelOracle::inside_side(const Point& p) const {
  return (vertex_.rho - p.rho) * std::cos(lean_) + (p.z - vertex_.z) * std::sin(lean_);
}

double DexelOracle::to_wedge(const Point& p) const {
  const double below = -over_bottom(p), beside = -inside_side(p);
  if (below <= 0 && beside <= 0) return std::max(below, beside);
  // Feet on the wedge's sides count where they lie on it.
  const Point on_bottom{p.rho - below * std::sin(bottom_), p.z + below * std::cos(bottom_)};
  const Point on_side{p.rho - beside * std::cos(lean_), p.z + beside * std::sin(lean_)};
  if (below > 0 && inside_side(on_bottom) >= 0) return below;
  if (beside > 0 && over_bottom(on_side) >= 0) return beside;
  return std::hypot(p.rho - vertex_.rho, p.z - vertex_.z);
}

double DexelOracle::value(double rho, double z) const {
  return std::max(to_wedge({rho, z}) - corner_, z - length_);
}

double DexelOracle::swept(const Vec3& from, const Vec3& to, const Vec3& p) const {
  const auto at = [&](double t) {
    const Vec3 q = p - lerp(from, to, t);
    return value(std::hypot(q.x, q.y), q.z);
  };
  constexpr double kGolden = 0.6180339887498949;
  double a = 0, b = 1, least = std::min(at(0), at(1));
  for (int i = 0; i < 80; ++i) {
    const double u = b - kGolden * (b - a), v = a + kGolden * (b - a), fu = at(u), fv = at(v);
    least = std::min({least, fu, fv});
    (fu < fv ? b : a) = fu < fv ? v : u;
  }
  return least;
}

}  // namespace limitgauge::simulator::test
