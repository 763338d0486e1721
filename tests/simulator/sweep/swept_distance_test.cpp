#include "simulator/sweep/swept_distance.h"

#include <cmath>
#include <random>
#include <vector>

#include "model/part/cutter.h"
#include "tests/simulator/sweep/profile_oracle.h"
#include "tests/support/catch.h"

namespace {

using namespace limitgauge;
using model::Cutter;
using model::CutterType;
using model::Vec3;
using simulator::CutterProfile;
using simulator::swept_distance;
using simulator::SweptMove;
using simulator::SweptSample;

Cutter make(CutterType type, double diameter, double corner, double angle, double flutes) {
  Cutter c;
  c.type = type, c.diameter_mm = diameter, c.corner_radius_mm = corner;
  c.taper_angle_deg = angle, c.flute_length_mm = flutes;
  return c;
}

std::vector<Cutter> cutters() {
  return simulator::test::all_cutters();
}

struct Draw {
  std::mt19937_64 random;
  double in(double low, double high) { return std::uniform_real_distribution<>(low, high)(random); }
  Vec3 vec(double half) { return {in(-half, half), in(-half, half), in(-half, half)}; }
  // Sloped, level, vertical, zero-length and very short moves.
  Vec3 delta() {
    const Vec3 d = vec(4);
    switch (random() % 8) {
      case 0:
        return {d.x, d.y, 0};
      case 1:
        return {0, 0, d.z};
      case 2:
        return {};
      case 3:
        return d * 0.01;
      default:
        return d;
    }
  }
};

/// What the closed forms' rounding and the minimisation's 1e-10 mm leave; the golden section of the
/// sampling ends at 1e-10 of the move.
constexpr double kExact = 1e-8;

/// How far the swept distance and its sign are off for random moves and points.
struct Difference {
  double largest = 0, wrong_side = 0;
  int inside = 0, outside = 0;

  void add(const Cutter& cutter, Draw& draw) {
    const simulator::test::ProfileOracle oracle(cutter);
    const Vec3 from = draw.vec(2), to = from + draw.delta();
    const double reach = oracle.widest() + 2;
    const Vec3 p = from + Vec3{draw.in(-reach, reach), draw.in(-reach, reach),
                               draw.in(-4, cutter.flute_length_mm + 4)};
    const double d = swept_distance(CutterProfile(cutter), SweptMove(from, to, 0), p).distance;
    const double brute = simulator::test::brute_swept_distance(oracle, from, to, p, 40);
    largest = std::max(largest, std::abs(d - brute));
    const auto side = simulator::test::proven_side(oracle, from, to, p);
    inside += side == simulator::test::Side::inside;
    outside += side == simulator::test::Side::outside;
    if (side == simulator::test::Side::inside) wrong_side = std::max(wrong_side, d);
    if (side == simulator::test::Side::outside) wrong_side = std::max(wrong_side, -d);
  }
};

}  // namespace

TEST_CASE("the profile is as far from a point as its outline", "[property][swept_distance]") {
  Draw draw{std::mt19937_64(20260)};
  double below = 0, above = 0, wrong_side = 0;
  for (const Cutter& cutter : cutters()) {
    const CutterProfile profile(cutter);
    const simulator::test::ProfileOracle oracle(cutter);
    const auto outline = oracle.outline(1000);
    for (int i = 0; i < 300; ++i) {
      const double rho = draw.in(0, 9), z = draw.in(-4, 16);
      double least = 1e300;
      for (const auto& q : outline) least = std::min(least, std::hypot(rho - q.rho, z - q.z));
      const double d = profile.sample(rho, z).distance;
      below = std::max(below, std::abs(d) - least);
      above = std::max(above, least - std::abs(d));
      if ((d < 0) != oracle.inside(rho, z)) wrong_side = std::max(wrong_side, std::abs(d));
    }
  }
  CHECK(below <= 1e-12);
  // Points at most 0.015 mm apart: half of that at a point on the outline itself.
  CHECK(above <= 8e-3);
  CHECK(wrong_side <= 1e-12);
}

TEST_CASE("swept distance agrees with dense sampling of an independent profile",
          "[property][swept_distance]") {
  Draw draw{std::mt19937_64(20261)};
  Difference difference;
  for (const Cutter& cutter : cutters())
    for (int i = 0; i < 600; ++i) difference.add(cutter, draw);
  CHECK(difference.largest <= kExact);
  CHECK(difference.wrong_side <= 1e-9);
}

TEST_CASE("swept distance agrees for a hundred thousand cutters, moves and points",
          "[slow][swept_distance]") {
  Draw draw{std::mt19937_64(20267)};
  Difference difference;
  for (int i = 0; i < 110'000; ++i)
    difference.add(simulator::test::random_cutter(draw.random), draw);
  CHECK(difference.largest <= kExact);
  CHECK(difference.wrong_side <= 1e-9);
  CHECK(difference.inside > 10'000);
  CHECK(difference.outside > 10'000);
}

TEST_CASE("gradients support the convex swept distance", "[property][swept_distance]") {
  Draw draw{std::mt19937_64(20262)};
  double violation = 0;
  for (const Cutter& cutter : cutters()) {
    const CutterProfile profile(cutter);
    for (int i = 0; i < 4000; ++i) {
      const Vec3 from = draw.vec(2);
      const SweptMove move(from, from + draw.delta(), 0);
      const Vec3 p = from + Vec3{draw.in(-6, 6), draw.in(-6, 6), draw.in(-3, 13)};
      const Vec3 q = p + draw.vec(draw.in(0.01, 3));
      const SweptSample a = swept_distance(profile, move, p);
      const double b = swept_distance(profile, move, q).distance;
      violation = std::max(violation, a.distance + dot(a.gradient, q - p) - b);
    }
  }
  CHECK(violation <= 1e-9);
}

TEST_CASE("curvature bound holds above the swept distance", "[property][swept_distance]") {
  Draw draw{std::mt19937_64(20263)};
  double violation = -1;
  int tight = 0;
  for (const Cutter& cutter : cutters()) {
    const CutterProfile profile(cutter);
    for (int i = 0; i < 4000; ++i) {
      const Vec3 from = draw.vec(2);
      const SweptMove move(from, from + draw.delta(), 0);
      const Vec3 p = from + Vec3{draw.in(-5, 5), draw.in(-5, 5), draw.in(-2, 12)};
      const double reach = draw.in(0.01, 1);
      const SweptSample a = swept_distance(profile, move, p);
      const double e = simulator::curvature_bound(profile, move, p, a, reach);
      tight += e < reach;
      for (int k = 0; k < 4; ++k) {
        const Vec3 step = normalized(draw.vec(1)) * reach;
        const double b = swept_distance(profile, move, p + step).distance;
        violation = std::max(violation, b - a.distance - dot(a.gradient, step) - e);
      }
    }
  }
  CHECK(violation <= 1e-9);
  // A bound that is always the Lipschitz one would be useless.
  CHECK(tight > 2000 * static_cast<int>(cutters().size()));
}

TEST_CASE("outside bound holds above the positive swept distance", "[property][swept_distance]") {
  Draw draw{std::mt19937_64(20265)};
  double violation = -1;
  for (const Cutter& cutter : cutters()) {
    const CutterProfile profile(cutter);
    for (int i = 0; i < 4000; ++i) {
      const Vec3 from = draw.vec(2);
      const SweptMove move(from, from + draw.delta(), 0);
      const Vec3 p = from + Vec3{draw.in(-5, 5), draw.in(-5, 5), draw.in(-2, 12)};
      const Vec3 half{draw.in(0.01, 1), draw.in(0.01, 1), draw.in(0.01, 1)};
      const SweptSample a = swept_distance(profile, move, p);
      const double e = simulator::outside_bound(profile, move, p, a, half);
      for (int k = 0; k < 4; ++k) {
        const Vec3 u = draw.vec(1), step{u.x * half.x, u.y * half.y, u.z * half.z};
        const double b = swept_distance(profile, move, p + step).distance;
        const double bound = a.distance + dot(a.gradient, step) + e;
        violation = std::max(violation, b - std::max(0.0, bound));
      }
    }
  }
  CHECK(violation <= 2e-9);
}

TEST_CASE("tree bound never exceeds the profile's distance", "[property][swept_distance]") {
  Draw draw{std::mt19937_64(20264)};
  double violation = -1;
  for (const Cutter& cutter : cutters()) {
    const CutterProfile profile(cutter);
    for (int i = 0; i < 4000; ++i) {
      const double rho = draw.in(0, 8), low = draw.in(-5, 14), high = low + draw.in(0, 3);
      const double bound = profile.lower_bound(rho, low, high);
      const double d = profile.sample(rho + draw.in(0, 2), draw.in(low, high)).distance;
      violation = std::max(violation, bound - d);
    }
  }
  CHECK(violation <= 1e-12);
}

TEST_CASE("the profile's largest radius is the cutter's", "[unit][swept_distance]") {
  for (const Cutter& cutter : cutters())
    CHECK(CutterProfile(cutter).largest_radius() ==
          Approx(model::largest_radius_mm(cutter)).margin(1e-12));
}

TEST_CASE("the profile reaches as far as its outline in every direction",
          "[property][swept_distance]") {
  Draw draw{std::mt19937_64(17)};
  constexpr int kPoints = 4000;
  for (const Cutter& c : cutters()) {
    const CutterProfile profile(c);
    const auto outline = simulator::test::ProfileOracle(c).outline(kPoints);
    for (int i = 0; i < 40; ++i) {
      const double angle = draw.in(-1.5708, 1.5708), rho = std::cos(angle), z = std::sin(angle);
      double reach = 0;
      for (const auto& p : outline) reach = std::max(reach, rho * p.rho + z * p.z);
      // Between points of the arc it is farther by a share of 1 − cos of half their angle.
      CHECK(profile.extent(rho, z) >= reach - kExact);
      CHECK(profile.extent(rho, z) <= reach + 1e-6);
      CHECK(profile.extent(3 * rho, 3 * z) == Approx(3 * profile.extent(rho, z)).margin(1e-12));
    }
  }
}

TEST_CASE("a quick look never rejects a move that is nearer than the bound",
          "[property][swept_distance]") {
  Draw draw{std::mt19937_64(20266)};
  int rejected = 0, wrongly = 0;
  for (const Cutter& cutter : cutters()) {
    const CutterProfile profile(cutter);
    for (int i = 0; i < 8000; ++i) {
      const Vec3 from = draw.vec(2);
      const SweptMove move(from, from + draw.delta(), 0);
      const Vec3 p = from + Vec3{draw.in(-8, 8), draw.in(-8, 8), draw.in(-4, 14)};
      const double d = swept_distance(profile, move, p).distance;
      const double bound = d + draw.in(-1, 1);
      if (!simulator::cannot_be_below(profile, move, p, bound)) continue;
      ++rejected;
      wrongly += d < bound - 1e-12;
    }
  }
  CHECK(wrongly == 0);
  CHECK(rejected > 5000);
}

TEST_CASE("a ball move below its flutes' top is the capsule", "[unit][swept_distance]") {
  const CutterProfile profile(make(CutterType::ball, 6, 3, 0, 20));
  const SweptMove move({0, 0, 0}, {10, 0, 5}, 0);
  // Below the middle of the move, straight under the centre line's normal (−1, 0, 2)/√5.
  const Vec3 foot{5, 0, 5.5};
  const Vec3 p = foot + Vec3{1, 0, -2} * (4.25 / std::sqrt(5.0));
  const SweptSample s = swept_distance(profile, move, p);
  CHECK(s.distance == Approx(1.25).margin(1e-12));
  CHECK(s.t == Approx(0.5).margin(1e-12));
  CHECK(dot(s.gradient, Vec3{1, 0, -2}) == Approx(std::sqrt(5.0)).margin(1e-12));
}

TEST_CASE("a flat plunge cuts from its lowest tip to its highest flute", "[unit][swept_distance]") {
  const CutterProfile profile(make(CutterType::flat, 8, 0, 0, 10));
  const SweptMove move({1, 2, 5}, {1, 2, -3}, 0);
  CHECK(swept_distance(profile, move, {1, 2, -4}).distance == Approx(1).margin(1e-12));
  CHECK(swept_distance(profile, move, {1, 2, 16.5}).distance == Approx(1.5).margin(1e-12));
  CHECK(swept_distance(profile, move, {7, 2, 6}).distance == Approx(2).margin(1e-12));
  CHECK(swept_distance(profile, move, {4, 2, 6}).distance == Approx(-1).margin(1e-12));
  CHECK(swept_distance(profile, move, {8, 2, -6}).distance ==
        Approx(std::sqrt(9.0 + 9.0)).margin(1e-12));
}

TEST_CASE("a taper that rises along a slope cuts under its wall", "[unit][swept_distance]") {
  // A 45 degree cone with a sharp tip that climbs at 45 degrees: the lower side of the swept space
  // is the tip's path and, across the move, the cone's wall.
  const CutterProfile profile(make(CutterType::taper, 0.2, 0.1, 45, 8));
  const SweptMove move({0, 0, 0}, {6, 0, 6}, 0);
  // The tip's ball (radius 0.1, no disc) runs along the line through (0, 0, 0.1).
  const Vec3 on_line{3, 0, 3.1};
  const Vec3 below = on_line + Vec3{1, 0, -1} * (0.6 / std::sqrt(2.0));
  CHECK(swept_distance(profile, move, below).distance == Approx(0.5).margin(1e-9));
}
