#include "verifier/stock_readings.h"

#include "tests/support/cages.h"
#include "tests/support/catch.h"
#include "tests/support/rasters.h"

namespace limitgauge::verifier {
namespace {

using model::Vec3;
using namespace tests;

const model::Stock kBlock = model::BoxStock{{-60, -60, -60}, {120, 120, 120}};
constexpr double kRadius = 3, kStep = 0.4;

/// A ball raster over the plane z = 0, `sunk` below it, and points of the stock that it leaves:
/// closed form, on a grid.
struct Bench {
  explicit Bench(double sunk_mm = 0) : sunk(sunk_mm), plane(plane_cage(4, 0, 0)) {
    pass = {ball_cutter(kRadius),
            shared(raster(6, kStep, 12, [&](double, double) { return -sunk; }))};
    for (double x = -4; x <= 4.0001; x += 0.05)
      for (double y = -4; y <= 4.0001; y += 0.05) readings.push_back({{x, y, stock_z(x)}, 1e-9});
    check.resolution_mm = 0.0005;
    check.field_spacing_mm = 1;
    check.voxel_mm = 0.05;
    check.readings_within_mm = 1;
  }
  double stock_z(double x) const {
    const double row = std::remainder(x + 6, kStep);
    return kRadius - std::sqrt(kRadius * kRadius - row * row) - sunk;
  }
  StageDeviation measure() const {
    return measure_stage(plane, kBlock, {&pass, 1}, readings, check, {2});
  }

  double sunk;
  ReferenceSurface plane;
  Pass pass;
  std::vector<StockReading> readings;
  StageCheck check;
};

std::string disagreement(const Bench& bench) {
  try {
    bench.measure();
  } catch (const InstrumentDisagreement& error) {
    return error.what();
  }
  return {};
}

}  // namespace

TEST_CASE("true readings agree and give the figures of the stock", "[unit]") {
  const StageDeviation clean = Bench().measure();
  CHECK(clean.voxel_gouge_mm == Approx(0).margin(1e-9));
  const double cusp = kRadius - std::sqrt(kRadius * kRadius - kStep * kStep / 4);
  CHECK(clean.voxel_uncut_mm == Approx(cusp).margin(1e-9));
  const StageDeviation sunk = Bench(0.01).measure();
  CHECK(sunk.voxel_gouge_mm == Approx(0.01).margin(1e-9));
  CHECK(sunk.gouge_mm.low == Approx(0.01).margin(0.0005));
}

TEST_CASE("a reading off the cut surface ends the run with both readings", "[unit]") {
  for (const double off : {2e-5, -2e-5, 0.01}) {
    Bench bench;
    bench.readings[4000].position.z += off;
    const std::string message = disagreement(bench);
    CAPTURE(off, message);
    CHECK(message.find("disagree") != std::string::npos);
    CHECK(message.find("analytic instrument") != std::string::npos);
    CHECK(message.find("voxel instrument") != std::string::npos);
  }
  // Within the error that the reading states for itself there is nothing to disagree about.
  Bench honest;
  honest.readings[4000].position.z += 2e-5;
  honest.readings[4000].error_mm = 2e-5;
  CHECK(disagreement(honest).empty());
}

TEST_CASE("a certified leftover that no reading shows ends the run", "[unit]") {
  Bench bench;
  const Vec3 at = bench.measure().uncuts.front().place.point;
  std::erase_if(bench.readings,
                [&](const StockReading& r) { return distance(r.position, at) < 0.5; });
  CHECK(disagreement(bench).find("certified leftover") != std::string::npos);
}

TEST_CASE("a cut from aside under the edge of S is no deep gouge", "[unit]") {
  // Past the edge of the plane at x = 4 a flat cutter takes the side away 5 µm inside: the stock's
  // wall stands under S all the way down, but nothing was cut from above.
  Bench bench;
  bench.readings.clear();
  model::Toolpath path;
  path.start = {4 + 2 - 0.005, -8, -3};
  feed_to(path, {4 + 2 - 0.005, 8, -3});
  bench.pass = {flat_cutter(2), shared(path)};
  for (double z = -2.9; z < 0; z += 0.1) bench.readings.push_back({{3.995, 0, z}, 1e-9});
  const StageDeviation d = bench.measure();
  CHECK(d.voxel_gouge_mm < 1e-6);
  CHECK(d.gouge_mm.low == Approx(0.005).margin(0.0005));
}

TEST_CASE("a ball that passes beside a sloped rim and reaches under it makes no deep gouge",
          "[unit]") {
  // z = x/2 up to x = 4, and a ball whose side takes 1 µm of the rim: along the normals of S beside
  // the rim the stock begins 0.4 mm further down, but beyond the rim, where S is no more.
  Bench bench;
  bench.plane = ReferenceSurface(plane_cage(4, 0.5, 0));
  const double radius = 1, x = 4.999;
  model::Toolpath path;
  path.start = {x, -8, 2 - radius};
  feed_to(path, {x, 8, 2 - radius});
  bench.pass = {ball_cutter(radius), shared(path)};
  bench.readings.clear();
  const Vec3 down = normalized(Vec3{0.5, 0, -1});
  for (double y = -3; y <= 3; y += 0.5)
    for (double inside : {2e-4, 5e-4, 8e-4}) {
      // From the foot to where its normal leaves the ball.
      const Vec3 to_foot = Vec3{4 - inside, y, 2 - inside / 2} - Vec3{x, y, 2};
      const double b = dot(to_foot, down);
      const double out = -b + std::sqrt(b * b - length_squared(to_foot) + radius * radius);
      bench.readings.push_back({Vec3{x, y, 2} + to_foot + down * out, 1e-9});
    }
  bench.check.readings_within_mm = 0;
  const StageDeviation d = bench.measure();
  CHECK(d.gouge_mm.high < 0.002);
  CHECK(d.voxel_gouge_mm <= d.gouge_mm.high);
}

TEST_CASE("a narrow pocket far deeper than its cutter is wide shows in the stock", "[unit]") {
  // Slots of a flat cutter of 0.4 mm, side by side and 2 mm deep: no place is deeper in a slot than
  // 0.2 mm, which is all that is proven to be reached; the way out of all of them is longer.
  Bench bench;
  model::Toolpath path;
  path.start = {-1, -1, 5};
  for (int row = 0; row <= 10; ++row) {
    const double x = -1 + 0.2 * row, y = row % 2 ? 1 : -1;
    feed_to(path, {x, y, -2});
    feed_to(path, {x, -y, -2});
  }
  bench.pass = {flat_cutter(0.2), shared(path)};
  bench.readings.clear();
  for (double x = -1; x <= 1; x += 0.1)
    for (double y = -1; y <= 1; y += 0.1) bench.readings.push_back({{x, y, -2}, 1e-9});
  bench.check.limits = {true, false, false, 0.5, 0, 0};
  const StageDeviation d = bench.measure();
  CHECK(d.gouge_mm.low < 0.3);
  CHECK(d.gouge_mm.high >= 1.1);  // from the middle to a wall of the pocket
  CHECK(d.voxel_gouge_mm == Approx(2));
  CHECK(decide(d, bench.check.limits).verdict == Verdict::fail);
}

TEST_CASE("stock beside the part, with air between, is neither leftover nor gouge", "[unit]") {
  // A block 3 mm over the tilted plane's lower end, 6 mm beside it: along the normal of the plane
  // it stands over S. And the floor beside its upper end lies under S along the normal.
  Bench bench;
  bench.plane = ReferenceSurface(plane_cage(4, 0.5, 0));
  const double cosine = 1 / std::sqrt(1.25);
  bench.pass = {ball_cutter(kRadius), shared(raster(8, 0.2, 16, [&](double x, double) {
                  return 0.5 * x + kRadius / cosine - kRadius;
                }))};
  bench.readings.clear();
  const StageDeviation alone = bench.measure();
  // The points are made up, so they state an error as large as their distance from the cut surface.
  for (double y = -3; y <= 3; y += 0.5) {
    bench.readings.push_back({{-6, y, 6}, 20});
    bench.readings.push_back({{6, y, -6}, 20});
  }
  bench.check.readings_within_mm = 0;
  const StageDeviation d = bench.measure();
  CHECK(d.voxel_gouge_mm <= alone.gouge_mm.high);
  CHECK(d.voxel_uncut_mm <= alone.uncut_mm.high);
}

}  // namespace limitgauge::verifier
