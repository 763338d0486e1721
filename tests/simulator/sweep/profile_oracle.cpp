#include "tests/simulator/sweep/profile_oracle.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

namespace limitgauge::simulator::test {

using model::CutterType;
using model::Vec3;
using std::numbers::pi;

ProfileOracle::ProfileOracle(const model::Cutter& c) {
  corner_ = c.type == CutterType::flat   ? 0
            : c.type == CutterType::ball ? c.diameter_mm / 2
                                         : c.corner_radius_mm;
  bottom_angle_ = c.tip_angle_deg * pi / 180;
  side_angle_ = c.taper_angle_deg * pi / 180;
  length_ = c.flute_length_mm;
  if (c.type == CutterType::apt || c.type == CutterType::drill) {
    // Where the bottom moved up by r, z = ρ·tan a + r / cos a, meets the side moved in by r,
    // ρ = D/2 − r / cos b + (z − D/2·tan a)·tan b.
    const double ta = std::tan(bottom_angle_), tb = std::tan(side_angle_);
    const double up = corner_ / std::cos(bottom_angle_), in = corner_ / std::cos(side_angle_);
    const double half = c.diameter_mm / 2;
    centre_.rho = (half - in + (up - half * ta) * tb) / (1 - ta * tb);
    centre_.z = centre_.rho * ta + up;
  } else {
    centre_ = {c.diameter_mm / 2 - corner_, corner_};
  }
  arc_begin_ = {centre_.rho + corner_ * std::sin(bottom_angle_),
                centre_.z - corner_ * std::cos(bottom_angle_)};
  arc_end_ = {centre_.rho + corner_ * std::cos(side_angle_),
              centre_.z - corner_ * std::sin(side_angle_)};
  rim_ = {std::max(0.0, arc_end_.rho + (length_ - arc_end_.z) * std::tan(side_angle_)), length_};
}

double ProfileOracle::widest() const {
  return std::max(rim_.rho, centre_.rho + corner_);
}

double ProfileOracle::to_segment(Point a, Point b, double rho, double z) const {
  const double dr = b.rho - a.rho, dz = b.z - a.z, l2 = dr * dr + dz * dz;
  const double t = l2 > 0 ? std::clamp(((rho - a.rho) * dr + (z - a.z) * dz) / l2, 0.0, 1.0) : 0.0;
  return std::hypot(rho - a.rho - t * dr, z - a.z - t * dz);
}

bool ProfileOracle::inside(double rho, double z) const {
  if (z > length_ || z < rho * std::tan(bottom_angle_)) return false;
  if (z >= arc_end_.z && rho > arc_end_.rho + (z - arc_end_.z) * std::tan(side_angle_))
    return false;
  // Only beyond the chord of the arc's ends does the arc decide.
  const double along = arc_end_.rho - arc_begin_.rho, up = arc_end_.z - arc_begin_.z;
  const double beyond = (rho - arc_begin_.rho) * up - (z - arc_begin_.z) * along;
  return beyond <= 0 || std::hypot(rho - centre_.rho, z - centre_.z) <= corner_;
}

double ProfileOracle::signed_distance(double rho, double z) const {
  double d = to_segment({0, 0}, arc_begin_, rho, z);
  d = std::min(d, to_segment(arc_end_, rim_, rho, z));
  d = std::min(d, to_segment(rim_, {0, length_}, rho, z));
  // The arc runs from the bottom's normal to the side's.
  const double around = std::atan2(z - centre_.z, rho - centre_.rho);
  if (corner_ > 0 && around >= bottom_angle_ - pi / 2 && around <= -side_angle_)
    d = std::min(d, std::abs(std::hypot(rho - centre_.rho, z - centre_.z) - corner_));
  return inside(rho, z) ? -d : d;
}

std::vector<ProfileOracle::Point> ProfileOracle::outline(int count) const {
  std::vector<Point> points;
  const auto along = [&](Point a, Point b) {
    for (int i = 0; i <= count; ++i) {
      const double t = static_cast<double>(i) / count;
      points.push_back({a.rho + t * (b.rho - a.rho), a.z + t * (b.z - a.z)});
    }
  };
  along({0, 0}, arc_begin_);
  for (int i = 0; i <= count; ++i) {
    const double from = bottom_angle_ - pi / 2, angle = from + (-side_angle_ - from) * i / count;
    points.push_back(
        {centre_.rho + corner_ * std::cos(angle), centre_.z + corner_ * std::sin(angle)});
  }
  along(arc_end_, rim_);
  along(rim_, {0, length_});
  return points;
}

namespace {

double at(const ProfileOracle& oracle, const Vec3& tip, const Vec3& p) {
  const Vec3 q = p - tip;
  return oracle.signed_distance(std::hypot(q.x, q.y), q.z);
}

/// Where the least of a convex function of t from 0 to 1 is, within 1e-11.
template <class F>
double golden_least(F&& f, double a, double b) {
  constexpr double kGolden = 0.6180339887498949;
  for (int i = 0; i < 50; ++i) {
    const double u = b - kGolden * (b - a), v = a + kGolden * (b - a);
    (f(u) < f(v) ? b : a) = f(u) < f(v) ? v : u;
  }
  return 0.5 * (a + b);
}

}  // namespace

double brute_swept_distance(const ProfileOracle& oracle, const Vec3& from, const Vec3& to,
                            const Vec3& p, int steps) {
  const auto value = [&](double t) { return at(oracle, lerp(from, to, t), p); };
  int best = 0;
  double least = value(0);
  for (int i = 1; i <= steps; ++i) {
    const double d = value(static_cast<double>(i) / steps);
    if (d < least) least = d, best = i;
  }
  const double a = std::max(0, best - 1) / static_cast<double>(steps);
  const double b = std::min(steps, best + 1) / static_cast<double>(steps);
  return std::min(least, value(golden_least(value, a, b)));
}

Side proven_side(const ProfileOracle& oracle, const Vec3& from, const Vec3& to, const Vec3& p) {
  const auto holds = [&](double t) {
    const Vec3 q = p - lerp(from, to, t);
    return oracle.inside(std::hypot(q.x, q.y), q.z);
  };
  const auto value = [&](double t) { return at(oracle, lerp(from, to, t), p); };
  if (holds(golden_least(value, 0, 1)) || holds(0) || holds(1)) return Side::inside;
  const double run = distance(from, to);
  std::vector<std::pair<double, double>> open = {{0, 1}};
  while (!open.empty()) {
    const auto [a, b] = open.back();
    open.pop_back();
    const double middle = (a + b) / 2, reach = run * (b - a) / 2;
    if (holds(middle)) return Side::inside;
    // The distance changes by no more than the way gone; less what rounding may add.
    if (value(middle) - 1e-12 > reach) continue;
    if (reach < 2e-10) return Side::on_surface;
    open.emplace_back(a, middle), open.emplace_back(middle, b);
  }
  return Side::outside;
}

std::vector<model::Cutter> all_cutters() {
  std::vector<model::Cutter> cutters;
  for (const char* text : {"flat:D=8,L=12",
                           "flat:D=6,L=2",
                           "ball:D=6,L=10",
                           "ball:D=4,L=2",
                           "bull:D=8,r=1,L=9",
                           "bull:D=6,r=2.5,L=4",
                           "taper:D=1,r=0.5,angle=5,L=12",
                           "taper:D=3,r=0.4,angle=30,L=6",
                           "taper:D=4,r=1.5,angle=20,L=1",
                           "drill:D=6,angle=118,L=12",
                           "drill:D=8,angle=90,L=4",
                           "drill:D=3,angle=140,L=9",
                           "apt:D=8,r=1,a=10,b=5,L=9",
                           "apt:D=8,r=2,b=-10,L=9",
                           "apt:D=6,a=20,b=-30,L=5",
                           "apt:D=6,r=1,a=15,b=-45,L=3.6",
                           "apt:D=6,r=6,a=45,L=12",
                           "apt:D=10,r=5,L=8",
                           "apt:D=4,b=20,a=5,L=7",
                           "apt:D=8,r=0.5,b=-45,L=3.9",
                           "apt:D=8,b=-45,L=4",
                           "apt:D=20,r=1.5,b=-60,L=5.2"})
    cutters.push_back(model::parse_cutter(text));
  return cutters;
}

model::Cutter random_cutter(std::mt19937_64& random) {
  const auto in = [&](double low, double high) {
    return std::uniform_real_distribution<>(low, high)(random);
  };
  for (;;) {
    model::Cutter c;
    c.type = static_cast<CutterType>(random() % 6);
    c.diameter_mm = in(1, 12);
    c.flute_length_mm = in(0.2, 14);
    const bool apt = c.type == CutterType::apt;
    if (c.type == CutterType::ball) c.corner_radius_mm = c.radius_mm();
    if (c.type == CutterType::bull || c.type == CutterType::taper)
      c.corner_radius_mm = in(0.01, 1) * c.radius_mm();
    if (apt && random() % 4 > 0) c.corner_radius_mm = in(0, 2) * c.radius_mm();
    if (c.type == CutterType::taper) c.taper_angle_deg = in(1, 70);
    if (c.type == CutterType::drill || apt) c.tip_angle_deg = in(1, 60);
    if (apt && random() % 4 == 0) c.tip_angle_deg = 0;
    if (apt) c.taper_angle_deg = in(-60, 60);
    try {
      require_valid(c);
      return c;
    } catch (const std::invalid_argument&) {
      // The next draw.
    }
  }
}

}  // namespace limitgauge::simulator::test
