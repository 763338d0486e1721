#include "verifier/probe/zero_shift.h"

#include <cmath>
#include <random>

#include "tests/support/catch.h"
#include "tests/verifier/probe/probe_stocks.h"

namespace limitgauge::verifier {
namespace {

using model::Vec3;

const Vec3 kPlanted_mm{0.003, -0.002, 0.0035};

/// Rows of a ball, and the sides of the block: points with normals of all kinds.
RowStock sampled_stock() {
  std::vector<std::pair<double, double>> rows;
  for (double y = -8; y <= 8; y += 1.6) rows.emplace_back(y, -3 + 0.05 * y * y / 8);
  return RowStock("ball:D=6,L=30", rows);
}

std::vector<Vec3> surface_points(const RemovedSpace& removed, std::size_t count) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> part(0, 1);
  std::vector<Vec3> points;
  while (points.size() < count) {
    const double x = 2 + 36 * part(random), y = -9 + 18 * part(random), z = -9 + 5 * part(random);
    switch (points.size() % 4) {
      case 0:
        points.push_back(on_surface(removed, {5, y, z}, {-5, y, z}));
        break;
      case 1:
        points.push_back(on_surface(removed, {x, 5, z}, {x, 15, z}));
        break;
      default:
        points.push_back(on_surface(removed, {x, y, -9}, {x, y, 5}));
    }
  }
  return points;
}

ZeroShift fit(const RemovedSpace& removed, const std::vector<Vec3>& points,
              const std::vector<double>& u_mm = {}, unsigned threads = 1) {
  const FitProblem problem{points.size(),
                           [&](std::size_t i, const Vec3& shift) {
                             const SurfaceGap gap = surface_gap(removed, points[i] - shift);
                             return FitGap{gap.value_mm, gap.normal};
                           },
                           u_mm};
  const auto found = fit_zero_shift(problem, {threads});
  REQUIRE(found);
  return *found;
}

void move_all(std::vector<Vec3>& points, const Vec3& by) {
  for (Vec3& p : points) p += by;
}

}  // namespace

TEST_CASE("a planted zero shift of 5 um comes back from 200 points", "[unit][probe]") {
  const RemovedSpace removed = sampled_stock().removed();
  std::vector<Vec3> points = surface_points(removed, 200);
  move_all(points, kPlanted_mm);
  const ZeroShift found = fit(removed, points);
  CHECK(found.settled);
  CHECK(found.rank() == 3);
  CHECK(found.degrees_of_freedom == 197);
  CHECK(found.rms_before_mm > 0.001);
  CHECK(found.rms_after_mm < 1e-8);
  for (int axis = 0; axis < 3; ++axis) {
    REQUIRE(found.axes_mm[axis]);
    CHECK(std::abs(*found.axes_mm[axis] - kPlanted_mm[axis]) < 1e-7);
  }
}

TEST_CASE("with noise the shift is off by its uncertainty", "[unit][probe]") {
  const RemovedSpace removed = sampled_stock().removed();
  const std::vector<Vec3> on = surface_points(removed, 200);
  constexpr double kNoise_mm = 0.002;
  double squares = 0;
  constexpr int kRuns = 30;
  for (int run = 0; run < kRuns; ++run) {
    std::mt19937 random(100 + run);
    std::normal_distribution<double> noise(0, kNoise_mm);
    std::vector<Vec3> points = on;
    for (Vec3& p : points) p += kPlanted_mm + surface_gap(removed, p).normal * noise(random);
    const ZeroShift found = fit(removed, points);
    const ZeroShift stated = fit(removed, points, std::vector<double>(200, kNoise_mm));
    CHECK(found.settled);
    REQUIRE(found.scatter_mm);
    CHECK(*found.scatter_mm == Approx(kNoise_mm).epsilon(0.25));
    CHECK(stated.chi2_after == Approx(197).epsilon(0.5));
    for (int axis = 0; axis < 3; ++axis) {
      REQUIRE(found.axes_u_mm[axis]);
      REQUIRE(stated.axes_u_mm[axis]);
      CHECK(*found.axes_mm[axis] == Approx(*stated.axes_mm[axis]).margin(1e-8));
      const double off = (*stated.axes_mm[axis] - kPlanted_mm[axis]) / *stated.axes_u_mm[axis];
      CHECK(std::abs(off) < 4.5);
      squares += off * off;
    }
  }
  // Of 90 deviations in units of their uncertainty: 1, within 3.5 of its own 0.15.
  CHECK(squares / (3 * kRuns) == Approx(1).margin(0.52));
}

TEST_CASE("weights follow the stated uncertainties", "[unit][probe]") {
  // Two levels of one plane, read 1 µm apart: the mean with weights 1/u².
  const FitProblem problem{2,
                           [](std::size_t i, const Vec3& s) {
                             return FitGap{(i == 0 ? 0.0 : 0.001) - s.z, {0, 0, 1}};
                           },
                           std::vector<double>{}};
  const std::vector<double> u = {0.001, 0.002};
  FitProblem weighted = problem;
  weighted.u_mm = u;
  const ZeroShift even = *fit_zero_shift(problem, {});
  const ZeroShift found = *fit_zero_shift(weighted, {});
  CHECK(even.shift_mm.z == Approx(0.0005));
  CHECK(*even.axes_u_mm[2] == Approx(0.0005));
  CHECK(found.shift_mm.z == Approx(0.0002));
  CHECK(*found.axes_u_mm[2] == Approx(0.001 * std::sqrt(0.8)));
  CHECK(found.chi2_after == Approx(0.2));
}

TEST_CASE("what the normals do not show is undetermined and not zero", "[unit][probe]") {
  const auto wall = [](std::size_t i, const Vec3& s) {
    const Vec3 n = i % 2 == 0 ? Vec3{1, 0, 0} : normalized(Vec3{1, 1, 0});
    return FitGap{dot(n, Vec3{0.01, 0.02, 0} - s), n};
  };
  const ZeroShift level = *fit_zero_shift({6, wall, {}}, {});
  CHECK(level.rank() == 2);
  CHECK(*level.axes_mm[0] == Approx(0.01));
  CHECK(*level.axes_mm[1] == Approx(0.02));
  CHECK_FALSE(level.axes_mm[2]);
  CHECK_FALSE(level.axes_u_mm[2]);
  CHECK(level.correlation[2]);
  CHECK_FALSE(level.correlation[0]);
  const auto plane = [](std::size_t, const Vec3& s) {
    const Vec3 n = normalized(Vec3{1, 1, 0});
    return FitGap{0.01 - dot(n, s), n};
  };
  const ZeroShift one = *fit_zero_shift({1, plane, {}}, {});
  CHECK(one.rank() == 1);
  CHECK(one.degrees_of_freedom == 0);
  CHECK(one.directions[0].determined);
  CHECK(one.directions[0].shift_mm == Approx(0.01));
  for (int axis = 0; axis < 3; ++axis) CHECK_FALSE(one.axes_mm[axis]);
  const auto nothing = [](std::size_t, const Vec3&) { return FitGap{0.01, {}}; };
  CHECK(fit_zero_shift({3, nothing, {}}, {})->rank() == 0);
  CHECK_FALSE(fit_zero_shift({0, nothing, {}}, {}));
}

TEST_CASE("a fit is the same for any number of threads", "[unit][probe]") {
  const RemovedSpace removed = sampled_stock().removed();
  std::vector<Vec3> points = surface_points(removed, 700);
  move_all(points, {0.02, 0.01, -0.03});
  const ZeroShift one = fit(removed, points, {}, 1), many = fit(removed, points, {}, 7);
  CHECK(one.shift_mm == many.shift_mm);
  CHECK(one.chi2_after == many.chi2_after);
  CHECK(one.last_step_mm == many.last_step_mm);
}

}  // namespace limitgauge::verifier
