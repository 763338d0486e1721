#include "verifier/swept_body.h"

#include <algorithm>
#include <numbers>
#include <random>

#include "tests/support/catch.h"

namespace limitgauge::verifier {
namespace {

using model::Cutter;
using model::CutterType;
using model::Vec3;

const std::vector<Cutter>& cutters() {
  static const std::vector<Cutter> all = {
      {"ball", CutterType::ball, 6, 3, 0, 40, {}, {}},
      {"flat", CutterType::flat, 8, 0, 0, 40, {}, {}},
      {"bull", CutterType::bull, 10, 2, 0, 40, {}, {}},
      {"taper", CutterType::taper, 4, 1, 10, 40, {}, {}},
      {"taper ball", CutterType::taper, 1, 0.5, 5, 40, {}, {}},
      {"short bull", CutterType::bull, 10, 2, 0, 4, {}, {}},
      {"short taper", CutterType::taper, 3, 0.5, 20, 5, {}, {}},
  };
  return all;
}

/// Distance from (rho, h) to the cutter's outline, by walking along the outline: an evaluator that
/// knows nothing of cores. Sign by which side of the outline the point is on.
double outline_distance(const Cutter& c, double rho, double h) {
  const double r = c.type == CutterType::flat ? 0 : c.corner_radius_mm;
  const double angle = c.taper_angle_deg * std::numbers::pi / 180, flat = c.radius_mm() - r;
  double best = std::max(rho - flat, 0.0) * 0 + 1e300;
  const auto see = [&](double x, double y) { best = std::min(best, std::hypot(rho - x, h - y)); };
  // Bottom, corner arc up to where the wall begins, wall.
  see(std::min(rho, flat), 0);
  const double arc_from = -std::numbers::pi / 2, arc_to = -angle;
  for (int k = 0; k <= 20000; ++k) {
    const double a = arc_from + (arc_to - arc_from) * k / 20000;
    see(flat + r * std::cos(a), r + r * std::sin(a));
  }
  const double wx = flat + r * std::cos(angle), wy = r - r * std::sin(angle);
  const double along = std::max(0.0, (rho - wx) * std::sin(angle) + (h - wy) * std::cos(angle));
  see(wx + along * std::sin(angle), wy + along * std::cos(angle));
  const double wall_rho = wx + (h - wy) * std::tan(angle);
  bool inside = h >= 0 && rho <= flat;
  if (h >= wy) inside = inside || rho <= wall_rho;
  if (h >= 0 && h < wy && rho > flat) inside = std::hypot(rho - flat, h - r) <= r;
  return inside ? -best : best;
}

}  // namespace

TEST_CASE("profile distances agree with the outline", "[unit]") {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> rho(0, 9), height(-4, 20);
  for (const Cutter& c : cutters()) {
    const CutterProfile profile(c);
    for (int n = 0; n < 60; ++n) {
      const double x = rho(random), h = height(random);
      CAPTURE(c.id, x, h);
      // The outline is walked in steps of at most r·π/2/20000 = 2.4e-4 mm: second order in it.
      CHECK(open_distance(profile, x, h).value == Approx(outline_distance(c, x, h)).margin(1e-6));
    }
  }
}

TEST_CASE("the flat top ends the profile, exactly so beyond its rim", "[unit]") {
  const CutterProfile bull(Cutter{"bull", CutterType::bull, 10, 2, 0, 4, {}, {}});
  CHECK(closed_distance(bull, 2, 7).value == Approx(3));
  CHECK(closed_distance(bull, 8, 8).value == Approx(5));  // rim at (5, 4)
  CHECK(closed_distance(bull, 4, 3.5).value == Approx(-0.5));
  CHECK(closed_distance(bull, 6, 3.5).value == Approx(1));
  const CutterProfile taper(Cutter{"taper", CutterType::taper, 2, 0, 45, 10, {}, {}});
  CHECK(taper.top_radius_mm() == Approx(11));
  CHECK(closed_distance(taper, 14, 14).value == Approx(5));  // rim at (11, 10)
  CHECK(closed_distance(taper, 12, 9.5).value == Approx(std::sqrt(1.25)));
  CHECK(closed_distance(taper, 12, 8.5).value == Approx(2.5 / std::sqrt(2)));  // wall below the rim
  CHECK(closed_distance(taper, 2, 13).value == Approx(3));
}

TEST_CASE("swept distance is the least over positions of the move", "[property]") {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> part(-6, 6);
  for (const Cutter& c : cutters()) {
    const CutterProfile profile(c);
    for (int n = 0; n < 60; ++n) {
      const Vec3 a{part(random), part(random), part(random)};
      Vec3 b{part(random), part(random), part(random)};
      if (n % 5 == 1) b.z = a.z;             // level
      if (n % 5 == 2) b.x = a.x, b.y = a.y;  // plunge or retract
      if (n % 5 == 3) b = a;                 // no length
      const Vec3 p{part(random), part(random), part(random)};
      const SweptBody body(a, b);
      double brute = 1e300;
      for (int k = 0; k <= 4000; ++k) {
        const Vec3 tip = lerp(a, b, k / 4000.0);
        brute = std::min(
            brute,
            closed_distance(profile, std::hypot(p.x - tip.x, p.y - tip.y), p.z - tip.z).value);
      }
      CAPTURE(c.id, n, a.x, a.y, a.z, b.x, b.y, b.z, p.x, p.y, p.z);
      const double d = body_value(profile, body, p);
      CHECK(d <= brute + 1e-12);
      // Steps of at most 21 mm / 4000: first order at a kink, so half a step.
      CHECK(d >= brute - 3e-3);
    }
  }
}

TEST_CASE("supporting planes lie below the distance everywhere", "[property]") {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> part(-8, 8);
  const auto random_point = [&] { return Vec3{part(random), part(random), part(random)}; };
  for (const Cutter& c : cutters()) {
    const CutterProfile profile(c);
    for (int n = 0; n < 400; ++n) {
      const SweptBody body(random_point(), random_point());
      const Vec3 p = random_point(), q = random_point();
      const BodyDistance d = body_distance(profile, body, p);
      CAPTURE(c.id, n);
      CHECK(body_value(profile, body, q) >= d.value + dot(d.gradient, q - p) - d.slack_mm - 1e-12);
      CHECK(d.slack_mm < 1e-9);
      CHECK(body_value(profile, body, p) >= box_bound(
                                                profile,
                                                [&] {
                                                  model::Box3 box;
                                                  box.add(body.from), box.add(body.to);
                                                  return box;
                                                }(),
                                                p) -
                                                1e-12);
    }
  }
}

TEST_CASE("a straight ball move is a capsule below the shaft", "[unit]") {
  const CutterProfile ball(cutters()[0]);
  const SweptBody body({0, 0, 0}, {10, 0, 0});  // centres at z = 3
  CHECK(body_value(ball, body, {5, 0, -1}) == Approx(1));
  CHECK(body_value(ball, body, {5, 4, 3}) == Approx(1));
  CHECK(body_value(ball, body, {13, 4, 3}) == Approx(2));
  CHECK(body_value(ball, body, {5, 0, 1}) == Approx(-1));
  CHECK(body_value(ball, body, {5, 5, 20}) == Approx(2));  // beside the shaft
  CHECK(body_value(ball, body, {5, 0, 41}) == Approx(1));  // over the flutes
}

TEST_CASE("the batch of sixteen equals single evaluations", "[unit]") {
  std::mt19937 random(6);
  std::uniform_real_distribution<double> part(-8, 8);
  Bezier cell;
  for (int k = 0; k < 16; ++k) cell.set(k, {part(random), part(random), part(random)});
  for (const Cutter& c : cutters()) {
    const CutterProfile profile(c);
    const SweptBody body({-3, 1, 0.5}, {2, 3, -0.25});
    std::array<double, 16> out{};
    body_values(profile, body, cell, out);
    for (int k = 0; k < 16; ++k) CHECK(out[k] == body_value(profile, body, cell.control(k)));
  }
}

}  // namespace limitgauge::verifier
