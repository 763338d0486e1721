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

}  // namespace limitgauge::verifier
