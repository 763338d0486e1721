#include "verifier/surface/bezier.h"

#include <algorithm>
#include <random>

#include "tests/support/catch.h"

namespace limitgauge::verifier {
namespace {

using model::Vec3;

Bezier random_patch(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> part(-5, 5);
  Bezier b;
  for (int k = 0; k < 16; ++k) b.set(k, {part(random), part(random), part(random)});
  return b;
}

}  // namespace

TEST_CASE("parts of a patch are the patch over a smaller square", "[unit]") {
  const Bezier b = random_patch(1);
  const Bezier part = restrict(b, 0.2, 0.7, 0.5, 0.9);
  const auto [left, right] = split_u(b);
  const auto [lower, upper] = split_v(b);
  for (double s = 0; s <= 1; s += 0.25)
    for (double t = 0; t <= 1; t += 0.25) {
      CHECK(distance(point(part, s, t), point(b, 0.2 + 0.5 * s, 0.5 + 0.4 * t)) < 1e-13);
      CHECK(distance(point(left, s, t), point(b, s / 2, t)) < 1e-13);
      CHECK(distance(point(right, s, t), point(b, 0.5 + s / 2, t)) < 1e-13);
      CHECK(distance(point(lower, s, t), point(b, s, t / 2)) < 1e-13);
      CHECK(distance(point(upper, s, t), point(b, s, 0.5 + t / 2)) < 1e-13);
    }
}

TEST_CASE("what a linear function changes by along u and along v", "[unit]") {
  // A wall 8 mm long and 3 mm high, u along it.
  Bezier wall;
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 4; ++i) wall.set(4 * j + i, {8 * i / 3.0, 0, 3 * j / 3.0});
  const Change level = change_of(wall, {0.5, 2, 0}), up = change_of(wall, {0, 1, -1});
  CHECK(level.u == Approx(4));
  CHECK(level.v == 0);
  CHECK(up.u == 0);
  CHECK(up.v == Approx(3));
  CHECK(level.most() == level.u);
  // It bounds how far values lie apart, and halves with the patch where that is straight.
  CHECK(change_of(split_u(wall)[0], {0.5, 2, 0}).u == Approx(2));
  const Bezier b = random_patch(9);
  const Vec3 gradient{0.3, -0.5, 0.8};
  const Change change = change_of(b, gradient);
  for (double u = 0; u <= 1; u += 0.125)
    for (double v = 0; v <= 1; v += 0.125)
      CHECK(std::abs(dot(gradient, point(b, u, v) - point(b, 1 - u, 1 - v))) <=
            change.u + change.v + 1e-12);
}

TEST_CASE("derivatives agree with differences", "[unit]") {
  const Bezier b = random_patch(2);
  const double h = 1e-5;  // central differences: error of order h² and 1e-16 / h
  for (double u = 0.1; u < 1; u += 0.2)
    for (double v = 0.1; v < 1; v += 0.2) {
      const BezierJet j = jet(b, u, v);
      CHECK(distance(j.du, (point(b, u + h, v) - point(b, u - h, v)) / (2 * h)) < 1e-7);
      CHECK(distance(j.dv, (point(b, u, v + h) - point(b, u, v - h)) / (2 * h)) < 1e-7);
      CHECK(distance(j.duu, (jet(b, u + h, v).du - jet(b, u - h, v).du) / (2 * h)) < 1e-6);
      CHECK(distance(j.duv, (jet(b, u, v + h).du - jet(b, u, v - h).du) / (2 * h)) < 1e-6);
      CHECK(distance(j.dvv, (jet(b, u, v + h).dv - jet(b, u, v - h).dv) / (2 * h)) < 1e-6);
    }
}

TEST_CASE("a plane's range over the control points is that of them one by one", "[property]") {
  for (unsigned seed = 40; seed < 60; ++seed) {
    const Bezier b = random_patch(seed), slopes = random_patch(seed + 100);
    const model::Vec3 g = slopes.control(5);
    model::Interval range = model::Interval::none();
    double radius = 0;
    for (int k = 0; k < 16; ++k) {
      range.add(0.3 + g.x * b.x[k] + g.y * b.y[k] + g.z * b.z[k]);
      radius = std::max(radius, distance(b.control(k), g));
    }
    CHECK(control_range(b, 0.3, g).low == range.low);
    CHECK(control_range(b, 0.3, g).high == range.high);
    CHECK(control_radius(b, g) == radius);
    model::Box3 box;
    for (int k = 0; k < 16; ++k) box.add(b.control(k));
    CHECK(control_box(b).low == box.low);
    CHECK(control_box(b).high == box.high);
  }
}

TEST_CASE("the hull holds the patch", "[property]") {
  for (unsigned seed = 10; seed < 30; ++seed) {
    const Bezier b = random_patch(seed);
    const model::Box3 box = control_box(b).grown(1e-12);
    const double radius = control_radius(b, point(b, 0.5, 0.5)) + 1e-12;
    for (double u = 0; u <= 1; u += 0.1)
      for (double v = 0; v <= 1; v += 0.1) {
        CHECK(box.contains(point(b, u, v)));
        CHECK(distance(point(b, u, v), point(b, 0.5, 0.5)) <= radius);
      }
  }
}

}  // namespace limitgauge::verifier
