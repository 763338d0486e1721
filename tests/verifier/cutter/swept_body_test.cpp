#include "verifier/cutter/swept_body.h"

#include <algorithm>
#include <numbers>
#include <random>

#include "model/part/cutter.h"
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
      model::parse_cutter("drill:D=6,angle=118,L=40"),
      model::parse_cutter("drill:D=8,angle=90,L=5"),
      model::parse_cutter("apt:D=8,r=1,a=10,b=5,L=30"),
      model::parse_cutter("apt:D=6,r=6,a=45,L=12"),
      model::parse_cutter("apt:D=10,r=2,b=-10,L=9"),
      model::parse_cutter("apt:D=6,a=20,b=-30,L=5"),
      model::parse_cutter("apt:D=8,b=-45,L=4"),
  };
  return all;
}

/// Distance from (rho, h) to the outline of the cutter, its wall going up without end (upright
/// where it leans inwards), by walking along the outline: an evaluator that knows nothing of cores.
/// Sign by which side of the outline the point is on.
double outline_distance(const Cutter& cutter, double rho, double h) {
  const model::SevenFigures c = model::seven_figures(cutter);
  const double r = c.corner_radius, e = c.centre_radius, f = c.centre_height;
  const double a = c.lower_angle * std::numbers::pi / 180;
  const double b = std::max(0.0, c.upper_angle) * std::numbers::pi / 180;
  double best = 1e300;
  const auto see = [&](double x, double y) { best = std::min(best, std::hypot(rho - x, h - y)); };
  // Bottom, corner arc up to where the wall begins, wall.
  const double bottom_ends = (e + r * std::sin(a)) / std::cos(a);
  const double along = std::clamp(rho * std::cos(a) + h * std::sin(a), 0.0, bottom_ends);
  see(along * std::cos(a), along * std::sin(a));
  const double arc_from = a - std::numbers::pi / 2, arc_to = -b;
  for (int k = 0; k <= 20000; ++k) {
    const double at = arc_from + (arc_to - arc_from) * k / 20000;
    see(e + r * std::cos(at), f + r * std::sin(at));
  }
  const double wx = e + r * std::cos(b), wy = f - r * std::sin(b);
  const double up = std::max(0.0, (rho - wx) * std::sin(b) + (h - wy) * std::cos(b));
  see(wx + up * std::sin(b), wy + up * std::cos(b));
  const double arc_begins = e + r * std::sin(a);
  bool inside = h >= rho * std::tan(a);
  if (h >= wy) inside = inside && rho <= wx + (h - wy) * std::tan(b);
  if (h < wy && rho > arc_begins) inside = inside && std::hypot(rho - e, h - f) <= r;
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

TEST_CASE("a side that leans inwards, and a tip, as formulas have them", "[unit]") {
  // Bottom to (5, 0), side ρ + h = 5 up to (1, 4), top.
  const CutterProfile dovetail(model::parse_cutter("apt:D=10,b=-45,L=4"));
  CHECK(dovetail.top_radius_mm() == Approx(1));
  CHECK(dovetail.largest_radius_mm() == Approx(5));
  CHECK(closed_distance(dovetail, 5, 4).value == Approx(4 / std::sqrt(2)));
  CHECK(closed_distance(dovetail, 0.5, 6).value == Approx(2));
  CHECK(closed_distance(dovetail, 3, 7).value == Approx(std::sqrt(13)));  // over the rim
  CHECK(closed_distance(dovetail, 3, 5).value == Approx(3 / std::sqrt(2)));
  CHECK(closed_distance(dovetail, 1, 1).value == Approx(-1));
  CHECK(closed_distance(dovetail, 8, -4).value == Approx(5));
  // Endless, its side goes up from (5, 0).
  CHECK(open_distance(dovetail, 5, 4).value == Approx(0).margin(1e-15));
  CHECK(open_distance(dovetail, 1, 9).value == Approx(-4));
  // A plunge from height 10 to 0 sweeps the cylinder of the widest place, up to the top's cone.
  const SweptBody plunge({0, 0, 10}, {0, 0, 0});
  CHECK(body_value(dovetail, plunge, {6, 0, 5}) == Approx(1));
  CHECK(body_value(dovetail, plunge, {5, 0, 14}) == Approx(4 / std::sqrt(2)));
  const CutterProfile drill(model::parse_cutter("drill:D=6,angle=90,L=9"));
  CHECK(closed_distance(drill, 0, -1).value == Approx(1));
  CHECK(closed_distance(drill, 1, -2).value == Approx(std::sqrt(5)));      // the tip
  CHECK(closed_distance(drill, 3, 1).value == Approx(std::sqrt(2)));       // the point
  CHECK(closed_distance(drill, 4, 2.5).value == Approx(std::sqrt(1.25)));  // the corner
  CHECK(closed_distance(drill, 1, 2).value == Approx(-1 / std::sqrt(2)));
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
