#include "tests/simulator/profile_oracle.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace limitgauge::simulator::test {

using model::CutterType;
using model::Vec3;

ProfileOracle::ProfileOracle(const model::Cutter& c) {
  corner_ = c.type == CutterType::flat   ? 0
            : c.type == CutterType::ball ? c.diameter_mm / 2
                                         : c.corner_radius_mm;
  angle_ = c.type == CutterType::taper ? c.taper_angle_deg * std::numbers::pi / 180 : 0;
  disc_ = c.diameter_mm / 2 - corner_;
  length_ = c.flute_length_mm;
  arc_end_ = {disc_ + corner_ * std::cos(angle_), corner_ - corner_ * std::sin(angle_)};
  top_ = arc_end_.rho + (length_ - arc_end_.z) * std::tan(angle_);
}

double ProfileOracle::to_segment(Point a, Point b, double rho, double z) const {
  const double dr = b.rho - a.rho, dz = b.z - a.z, l2 = dr * dr + dz * dz;
  const double t = l2 > 0 ? std::clamp(((rho - a.rho) * dr + (z - a.z) * dz) / l2, 0.0, 1.0) : 0.0;
  return std::hypot(rho - a.rho - t * dr, z - a.z - t * dz);
}

bool ProfileOracle::inside(double rho, double z) const {
  if (z < 0 || z > length_) return false;
  if (z >= arc_end_.z) return rho <= arc_end_.rho + (z - arc_end_.z) * std::tan(angle_);
  if (rho <= disc_) return true;
  return std::hypot(rho - disc_, z - corner_) <= corner_;
}

double ProfileOracle::signed_distance(double rho, double z) const {
  double d = to_segment({0, 0}, {disc_, 0}, rho, z);
  d = std::min(d, to_segment(arc_end_, {top_, length_}, rho, z));
  d = std::min(d, to_segment({top_, length_}, {0, length_}, rho, z));
  // The arc runs from straight down to the wall's normal.
  const double around = std::atan2(z - corner_, rho - disc_);
  if (corner_ > 0 && around >= -std::numbers::pi / 2 && around <= -angle_)
    d = std::min(d, std::abs(std::hypot(rho - disc_, z - corner_) - corner_));
  return inside(rho, z) ? -d : d;
}

double brute_swept_distance(const ProfileOracle& oracle, const Vec3& from, const Vec3& to,
                            const Vec3& p, int steps) {
  const auto at = [&](double t) {
    const Vec3 q = p - lerp(from, to, t);
    return oracle.signed_distance(std::hypot(q.x, q.y), q.z);
  };
  int best = 0;
  double least = at(0);
  for (int i = 1; i <= steps; ++i) {
    const double d = at(static_cast<double>(i) / steps);
    if (d < least) least = d, best = i;
  }
  double a = std::max(0, best - 1) / static_cast<double>(steps);
  double b = std::min(steps, best + 1) / static_cast<double>(steps);
  constexpr double kGolden = 0.6180339887498949;
  for (int i = 0; i < 50; ++i) {
    const double u = b - kGolden * (b - a), v = a + kGolden * (b - a);
    (at(u) < at(v) ? b : a) = at(u) < at(v) ? v : u;
  }
  return std::min(least, at(0.5 * (a + b)));
}

}  // namespace limitgauge::simulator::test
