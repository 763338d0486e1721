#include "verifier/gate/findings.h"

#include <algorithm>
#include <numbers>

#include "tests/support/cages.h"
#include "tests/support/catch.h"
#include "tests/support/rasters.h"

namespace limitgauge::verifier {
namespace {

using model::Vec3;
using namespace tests;

const model::Stock kBlock = model::BoxStock{{-60, -60, -60}, {120, 120, 120}};
constexpr double kRadius = 3;

/// A raster at 0.2 mm over the plane z = 0, with rows at the given x sunk by `depth`.
model::Toolpath sunk_rows(const std::vector<double>& rows, double depth, double from_y = -5,
                          double to_y = 5) {
  return raster(5, 0.2, 0.1, [=](double x, double y) {
    for (const double row : rows)
      if (std::abs(x - row) < 1e-6 && y > from_y - 1e-6 && y < to_y + 1e-6) return -depth;
    return 0.0;
  });
}

StageDeviation measure(const model::Toolpath& path, const GateLimits& limits) {
  const ReferenceSurface plane(plane_cage(5, 0, 0));
  const Pass pass{ball_cutter(kRadius), shared(path)};
  StageCheck check;
  check.resolution_mm = 0.0005;
  check.field_spacing_mm = 5;  // far too wide to see any of this by sampling
  check.limits = limits;
  return measure_stage(plane, kBlock, {&pass, 1}, nullptr, check, {2});
}

}  // namespace

TEST_CASE("every gouge is one finding with its area, extent and program line", "[unit]") {
  // 10 µm deep, gate 4 µm: each strip is as wide as the circle is 6 µm further down.
  const double depth = 0.010, limit = 0.004;
  const double half = std::sqrt(kRadius * kRadius - std::pow(kRadius - (depth - limit), 2));
  const model::Toolpath path = sunk_rows({-3, 0.4, 3.6}, depth, -2, 2);
  const StageDeviation d = measure(path, {true, false, false, limit, 0, 0});
  REQUIRE(d.gouges.size() == 3);
  CHECK(d.findings_complete);
  CHECK(d.gouge_threshold_mm == limit);
  std::vector<double> rows;
  for (const Finding& f : d.gouges) {
    rows.push_back(f.place.point.x);
    CHECK(f.depth_mm == Approx(depth).margin(0.0006));
    // Beyond its ends the strip is round, as the ball is; cells at the rim are 0.03 mm in radius.
    const double area = 2 * half * 4 + std::numbers::pi * half * half;
    CHECK(f.area_mm2 == Approx(area).epsilon(0.1));
    CHECK(f.extent_mm.size().y == Approx(4 + 2 * half).margin(0.1));
    CHECK(f.extent_mm.size().x == Approx(2 * half).margin(0.1));
    CHECK(f.extent_mm.size().x <= 2 * half + 1e-9);
    CHECK(f.line == f.move + 1);
    const Vec3& to = path.moves[f.move].to;
    CHECK(std::abs(to.x - f.place.point.x) < 0.11);
    CHECK(f.body == "cutter");
  }
  std::sort(rows.begin(), rows.end());
  CHECK(rows[0] == Approx(-3).margin(half));
  CHECK(rows[1] == Approx(0.4).margin(half));
  CHECK(rows[2] == Approx(3.6).margin(half));
}

TEST_CASE("nothing is listed that the gate allows, but the deepest place", "[slow]") {
  const StageDeviation d = measure(sunk_rows({1}, 0.002), {true, false, false, 0.004, 0, 0});
  REQUIRE(d.gouges.size() == 1);
  CHECK(d.gouges.front().area_mm2 == 0);
  CHECK(d.gouges.front().depth_mm == Approx(0.002).margin(0.0005));
}

TEST_CASE("a leftover names the passes on both sides of it", "[unit]") {
  // The row at x = 1 is lifted off: two rows 0.4 mm apart leave 6.7 µm, the others 1.7 µm.
  const model::Toolpath path =
      raster(5, 0.2, 10, [](double x, double) { return std::abs(x - 1) < 1e-6 ? 1.0 : 0.0; });
  const StageDeviation d = measure(path, {false, true, false, 0, 0.004, 0});
  REQUIRE(d.uncuts.size() == 1);
  const Finding& f = d.uncuts.front();
  CHECK(f.place.point.x == Approx(1).margin(0.02));
  CHECK(f.extent_mm.size().y == Approx(10).margin(0.3));
  REQUIRE(f.passes.size() >= 2);
  std::vector<double> sides;
  for (const NearPass& p : f.passes) {
    CHECK(p.line == path.moves[p.move].line);
    sides.push_back(path.moves[p.move].to.x);
  }
  for (std::size_t k = 1; k < f.passes.size(); ++k)
    CHECK(f.passes[k].distance_mm >= f.passes[k - 1].distance_mm);
  CHECK(std::min(sides[0], sides[1]) == Approx(0.8));
  CHECK(std::max(sides[0], sides[1]) == Approx(1.2));
}

TEST_CASE("findings do not depend on the number of threads", "[unit][slow]") {
  const ReferenceSurface plane(plane_cage(5, 0, 0));
  const Pass pass{ball_cutter(kRadius), shared(sunk_rows({-3, 0.4}, 0.01))};
  StageCheck check;
  check.resolution_mm = 0.0005;
  check.limits = {true, true, false, 0.004, 0.001, 0};
  const auto run = [&](unsigned threads) {
    return measure_stage(plane, kBlock, {&pass, 1}, nullptr, check, {threads});
  };
  const StageDeviation one = run(1), three = run(3);
  REQUIRE(one.gouges.size() == three.gouges.size());
  REQUIRE(one.uncuts.size() == three.uncuts.size());
  for (std::size_t i = 0; i < one.uncuts.size(); ++i) {
    CHECK(one.uncuts[i].area_mm2 == three.uncuts[i].area_mm2);
    CHECK(one.uncuts[i].place.point == three.uncuts[i].place.point);
  }
}

}  // namespace limitgauge::verifier
