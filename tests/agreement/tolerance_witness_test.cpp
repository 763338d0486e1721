// The values that a figure over tolerances names, cut by the simulator: rays into its stock read
// the same there, though it knows nothing of tolerances.
#include <cmath>

#include "app/run/stock_probe.h"
#include "tests/support/cages.h"
#include "tests/support/catch.h"
#include "tests/support/rasters.h"
#include "verifier/gate/stock_rays.h"
#include "verifier/robust/robust_figures.h"
#include "verifier/surface/surface_tree.h"

namespace limitgauge {
namespace {

using namespace tests;
using model::Vec3;

const model::Stock kBowlBlock = model::BoxStock{{-12, -12, -10}, {24, 24, 14}};

/// The stock as it is cut by the passes with the figure's own values.
verifier::RayReading read_at_witness(const verifier::ReferenceSurface& bowl,
                                     const verifier::ToleranceBox& box,
                                     const verifier::RobustFigure& figure) {
  verifier::ToleranceValues values;
  for (const verifier::NamedLength& value : figure.at) values.push_back(value.mm);
  const std::vector<verifier::Pass> passes = box.passes_at(values);
  constexpr std::size_t kMemory = std::size_t{1} << 30;
  constexpr double kVoxel_mm = 0.2, kFar_mm = 60;
  simulator::StockModel stock(kBowlBlock, kVoxel_mm, kMemory);
  for (const verifier::Pass& pass : passes) stock = stock.cut({pass.cutter, pass.path}, {2});
  const app::StockRayProbe probe(stock);
  const verifier::SurfaceCells cells(bowl.tree(), 0.3);
  const verifier::RemovedSpace removed(kBowlBlock, passes), outside(kBowlBlock, {});
  return verifier::read_ray({cells, removed, outside, probe, kFar_mm}, figure.place->point,
                            figure.normal, 0);
}

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
    const verifier::StageDeviation d = measure_stage(bowl, kBowlBlock, passes, nullptr, check, {2});
    const verifier::ToleranceBox box(*check.tolerances, passes);
    CAPTURE(cutter.id);
    const verifier::RayReading deep = read_at_witness(bowl, box, d.robust->gouge);
    // A ray's own error bound, and what the certificate takes off for rounding.
    CHECK(d.robust->gouge.figure_mm.low > 0.01);
    CHECK(deep.gouge_mm == Approx(d.robust->gouge.figure_mm.low).margin(deep.error_mm + 1e-6));
    const verifier::RayReading left = read_at_witness(bowl, box, d.robust->uncut);
    CHECK(d.robust->uncut.figure_mm.low > 0.01);
    CHECK(left.uncut_mm == Approx(d.robust->uncut.figure_mm.low).margin(left.error_mm + 1e-6));
    // Measured as stated, neither is there.
    CHECK(d.robust->gouge.figure_mm.low > d.gouge_mm.high + 0.003);
    CHECK(d.robust->uncut.figure_mm.low > d.uncut_mm.high + 0.003);
  }
}

}  // namespace limitgauge
