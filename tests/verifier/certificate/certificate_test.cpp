#include <algorithm>
#include <cmath>

#include "tests/support/cages.h"
#include "tests/support/catch.h"
#include "tests/support/rasters.h"
#include "verifier/gate/verify.h"

namespace limitgauge::verifier {
namespace {

using model::Vec3;
using namespace tests;

const model::Stock kBlock = model::BoxStock{{-60, -60, -60}, {120, 120, 120}};

StageDeviation measure(const ReferenceSurface& surface, const model::Cutter& cutter,
                       model::Toolpath path, double resolution_mm, double allowance_mm = 0) {
  const Pass pass{cutter, shared(std::move(path))};
  StageCheck check;
  check.resolution_mm = resolution_mm;
  check.allowance_mm = allowance_mm;
  check.field_spacing_mm = 1;
  return measure_stage(surface, kBlock, {&pass, 1}, nullptr, check, {2});
}

/// Height of the cusp between two balls a step apart.
double scallop(double radius, double step) {
  return radius - std::sqrt(radius * radius - step * step / 4);
}

}  // namespace

TEST_CASE("a ball raster on a plane leaves the closed-form scallop", "[slow]") {
  const ReferenceSurface plane(plane_cage(5, 0, 0));
  for (const auto& [radius, step] : {std::pair{3.0, 0.25}, {3.0, 0.1}, {1.0, 0.2}, {5.0, 1.0}}) {
    const auto d = measure(plane, ball_cutter(radius),
                           raster(10, step, 5, [](double, double) { return 0.0; }), 0.0005);
    const double h = scallop(radius, step);
    CAPTURE(radius, step, h, d.uncut_mm.low, d.uncut_mm.high);
    CHECK(d.uncut_mm.low <= h);
    CHECK(d.uncut_mm.high >= h);
    CHECK(d.uncut_mm.width() <= 0.0005);
    CHECK(d.gouge_mm.low == 0);
    CHECK(d.gouge_mm.high <= 0.0005);
    CHECK(d.reached_resolution);
  }
}

TEST_CASE("a gouge by two cuts that end in one another is as deep as both", "[unit]") {
  // Two trenches of a flat cutter of 2 mm, side by side and 3 mm deep, overlapping by 0.2 mm: from
  // anywhere between their outer walls the way down the normal ends on the floor, 3 mm below S,
  // however near the walls are.
  const ReferenceSurface plane(plane_cage(5, 0, 0));
  model::Toolpath path;
  path.start = {-0.9, -8, -3};
  for (const Vec3& to : {Vec3{-0.9, 8, -3}, Vec3{0.9, 8, -3}, Vec3{0.9, -8, -3}}) feed_to(path, to);
  const auto d = measure(plane, flat_cutter(1), path, 0.01);
  CHECK(d.gouge_mm.low <= 3);
  CHECK(d.gouge_mm.high >= 3);
  CHECK(d.gouge_mm.width() <= 0.01);
}

TEST_CASE("a flat's steps in a slope are as deep in all passes as in one", "[slow]") {
  // On a plane of 45 degrees each row of a flat goes as far down at its corner as the rows are
  // apart: what stands are steps whose outer corners touch S, and whose inner ones lie under it. An
  // inner corner lies a step, times cos 45°, under the middle between two outer ones.
  const ReferenceSurface plane(plane_cage(5, 1, 0));
  const double step = 0.2;
  const auto d =
      measure(plane, flat_cutter(1),
              raster(9, step, 9, [&](double x, double) { return x + 1 - step; }), 0.0005);
  CHECK(d.gouge_mm.low == Approx(step / std::sqrt(2)).margin(0.0005));
  CHECK(d.gouge_mm.high == Approx(step / std::sqrt(2)).margin(0.0005));
}

TEST_CASE("scallop on a slope, measured normal to it", "[unit]") {
  const double slope = 0.75;  // rises along x: rows along y follow the contours
  const double cosine = 1 / std::sqrt(1 + slope * slope), radius = 3, step = 0.2;
  const ReferenceSurface plane(plane_cage(5, slope, 0));
  // The tip of a ball that touches the plane under its centre line.
  const auto tip = [&](double x, double) { return slope * x + radius / cosine - radius; };
  const auto d = measure(plane, ball_cutter(radius), raster(12, step, 6, tip), 0.0005);
  const double h = scallop(radius, step / cosine);
  CHECK(d.uncut_mm.low <= h);
  CHECK(d.uncut_mm.high >= h);
  CHECK(d.uncut_mm.width() <= 0.0005);
  CHECK(d.gouge_mm.low == 0);
}

TEST_CASE("a pass sunk by two micrometres is a gouge of two micrometres", "[unit]") {
  const ReferenceSurface plane(plane_cage(5, 0, 0));
  const auto path =
      raster(10, 0.1, 5, [](double x, double) { return std::abs(x - 1) < 1e-9 ? -0.002 : 0.0; });
  const auto d = measure(plane, ball_cutter(3), path, 0.0005);
  CHECK(d.gouge_mm.low <= 0.002);
  CHECK(d.gouge_mm.high >= 0.002);
  CHECK(d.gouge_mm.low > 0.0014);
  REQUIRE(!d.gouges.empty());
  CHECK(std::abs(d.gouges.front().place.point.x - 1) < 0.1);
  const auto clean = measure(plane, ball_cutter(3),
                             raster(10, 0.1, 5, [](double, double) { return 0.0; }), 0.0005);
  CHECK(clean.gouge_mm.low == 0);
  CHECK(clean.gouge_mm.high <= 0.0005);
}

TEST_CASE("a flat cutter over a plane leaves what it stands above", "[unit]") {
  const ReferenceSurface plane(plane_cage(5, 0, 0));
  for (const double height : {0.0, 0.2, -0.03}) {
    const auto d = measure(plane, flat_cutter(4),
                           raster(12, 6, 12, [&](double, double) { return height; }), 0.001);
    CAPTURE(height, d.uncut_mm.low, d.uncut_mm.high, d.gouge_mm.low, d.gouge_mm.high);
    CHECK(d.uncut_mm.low == Approx(std::max(0.0, height)).margin(1e-6));
    CHECK(d.uncut_mm.high == Approx(std::max(0.0, height)).margin(0.001));
    CHECK(d.gouge_mm.low == Approx(std::max(0.0, -height)).margin(1e-6));
  }
}

TEST_CASE("allowance shifts what is uncut and what is gouged", "[unit]") {
  const ReferenceSurface plane(plane_cage(5, 0, 0));
  const auto d = measure(plane, ball_cutter(3),
                         raster(10, 0.1, 5, [](double, double) { return 0.19; }), 0.0005, 0.2);
  CHECK(d.gouge_mm.low <= 0.01);
  CHECK(d.gouge_mm.low >= 0.01 - 0.0005);
  CHECK(d.gouge_mm.high == Approx(0.01).margin(0.0005));
  CHECK(d.uncut_mm.low == 0);
}

TEST_CASE("a limit within the width asked for is decided all the same", "[unit]") {
  const ReferenceSurface plane(plane_cage(5, 0, 0));
  const double radius = 3, step = 0.3, h = scallop(radius, step);
  const Pass pass{ball_cutter(radius),
                  shared(raster(10, step, 5, [](double, double) { return 0.0; }))};
  StageCheck check;
  check.field_spacing_mm = 1;
  check.resolution_mm = 0.001;
  // Three hundredths and one hundredth of the width to either side of the truth.
  for (const double off : {3e-5, 1e-5, -1e-5, -3e-5}) {
    check.limits = {false, true, false, 0, h + off, 0};
    const StageDeviation d = measure_stage(plane, kBlock, {&pass, 1}, nullptr, check, {2});
    CAPTURE(off, h, d.uncut_mm.low, d.uncut_mm.high);
    CHECK(d.uncut_mm.low <= h);
    CHECK(d.uncut_mm.high >= h);
    CHECK(decide(d, check.limits).verdict == (off > 0 ? Verdict::pass : Verdict::fail));
  }
}

TEST_CASE("a surface that lies on the limit throughout is covered", "[unit]") {
  const ReferenceSurface plane(plane_cage(5, 0, 0));
  // 0.05 as a float is above 0.05, 0.03 below.
  for (const double left : {0.05, 0.03, -0.05}) {
    const Pass pass{flat_cutter(4), shared(raster(10, 1, 5, [&](double, double) { return left; }))};
    StageCheck check;
    check.resolution_mm = 0.005;
    check.field_spacing_mm = 1;
    for (const double off : {0.0, 1e-4}) {
      check.limits = {true, true, false, 0.05 - off, std::max(left, 0.0) - off, 0};
      const auto d = measure_stage(plane, kBlock, {&pass, 1}, nullptr, check, {2});
      CAPTURE(left, off);
      CHECK(d.coverage == (off == 0 ? 1 : 0));
    }
  }
}

TEST_CASE("the error of an arc's chords is part of the interval", "[unit]") {
  const ReferenceSurface plane(plane_cage(5, 0, 0));
  model::Toolpath path = raster(10, 0.1, 5, [](double, double) { return -0.01; });
  path.chord_error_mm = 0.002;
  const auto d = measure(plane, ball_cutter(3), path, 0.01);
  CHECK(d.gouge_mm.low <= 0.008);
  CHECK(d.gouge_mm.high >= 0.012);
  const auto chords = std::find_if(d.budget.begin(), d.budget.end(), [](const auto& term) {
    return term.source.find("chords") != std::string::npos;
  });
  REQUIRE(chords != d.budget.end());
  CHECK(chords->bound_mm == 0.002);
}

}  // namespace limitgauge::verifier
