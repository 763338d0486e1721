// The values that a figure over tolerances names, cut by the simulator: rays into its stock read
// the same there, though it knows nothing of tolerances.
#include <cmath>

#include "app/run/stock_probe.h"
#include "tests/support/cages.h"
#include "tests/support/catch.h"
#include "tests/support/rasters.h"
#include "verifier/gate/verify.h"

namespace limitgauge {
namespace {

using namespace tests;
using model::Vec3;

const model::Stock kBowlBlock = model::BoxStock{{-12, -12, -10}, {24, 24, 14}};

model::Tolerances tolerances_of(const char* tool) {
  const auto about = [](double half) { return model::Interval{-half, half}; };
  model::Tolerances t;
  t.zero_mm = {about(0.006), about(0.004), about(0.003)};
  t.tools[tool] = {about(0.01), about(0.005), {}, {}};
  return t;
}

}  // namespace

TEST_CASE("the simulated stock shows what tolerances lead to, at the values that are named",
          "[property][rays]") {
  const double bend = 0.04;
  const verifier::ReferenceSurface bowl(paraboloid_cage(3, bend));
  const auto wavy = [&](double x, double y) {
    return bend * (x * x + y * y) + 0.03 * std::sin(2 * x + y);
  };
  for (const model::Cutter& cutter : {ball_cutter(2), flat_cutter(1)}) {
    const double lift = cutter.type == model::CutterType::ball ? 0.01 : 0.1;
    const std::vector<verifier::Pass> passes{
        {cutter,
         shared(raster(4, 0.5, 0.5, [&](double x, double y) { return wavy(x, y) + lift; }))}};
    verifier::StageCheck check;
    check.resolution_mm = 0.001;
    check.field_spacing_mm = 1;
    check.tolerances = tolerances_of(cutter.id.c_str());
    constexpr std::size_t kMemory = std::size_t{1} << 30;
    constexpr double kVoxel_mm = 0.2;
    simulator::StockModel stock(kBowlBlock, kVoxel_mm, kMemory);
    const app::StockRayProbe probe(stock.cut({cutter, passes.front().path}, {2}), &kBowlBlock);
    const verifier::StageDeviation d = measure_stage(bowl, kBowlBlock, passes, &probe, check, {2});
    CAPTURE(cutter.id);
    // Rays end within their own error bound, of some nanometres; rounding is taken off `low`.
    constexpr double kRay_mm = 1e-5;
    for (const verifier::RobustFigure* figure : {&d.robust->gouge, &d.robust->uncut}) {
      CHECK(figure->figure_mm.low > 0.01);
      REQUIRE(figure->voxel_mm);
      CHECK(*figure->voxel_mm == Approx(figure->figure_mm.low).margin(kRay_mm));
    }
    // Measured as stated, neither is there.
    CHECK(d.robust->gouge.figure_mm.low > d.gouge_mm.high + 0.003);
    CHECK(d.robust->uncut.figure_mm.low > d.uncut_mm.high + 0.003);
  }
}

}  // namespace limitgauge
