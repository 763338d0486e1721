// Reach over a box of tolerances: what the smallest cutter of it touches counts.
#include <cmath>
#include <random>

#include "tests/support/cages.h"
#include "tests/support/catch.h"
#include "tests/support/effort.h"
#include "tests/support/rasters.h"
#include "verifier/gate/verify.h"
#include "verifier/reach/reachability.h"
#include "verifier/robust/tolerance_box.h"
#include "verifier/tolerance.h"

namespace limitgauge::verifier {
namespace {

using model::Cutter;
using model::CutterType;
using model::Interval;
using model::Tolerances;
using model::Vec3;
using namespace tests;

/// Cutters of each kind that rounds, with and without a neck, and what they may be off by.
struct Uncertain {
  Cutter cutter;
  model::ToolTolerance by;
};

std::vector<Uncertain> uncertain_cutters() {
  const model::ToolTolerance radius{Interval{-0.4, 0.2}, {}, {}, {}};
  const model::ToolTolerance corner{Interval{-0.2, 0.1}, {}, Interval{-0.1, 0.2}, {}};
  const model::ToolTolerance worn{Interval{-0.2, 0.1}, {}, Interval{0, 0.3}, {}};
  const model::ToolTolerance flat{{}, {}, Interval{-0.1, 0.2}, Interval{-0.2, 0.3}};
  std::vector<Uncertain> out{
      {ball_cutter(2), radius},
      {flat_cutter(2), worn},
      {{"bull", CutterType::bull, 4, 0.6, 0, 40, {}, {}}, corner},
      {{"bull", CutterType::bull, 4, 0.6, 0, 40, {}, {}}, flat},
      {{"taper", CutterType::taper, 3, 0.4, 10, 20, {}, {}}, corner},
  };
  for (Uncertain necked : {out[0], out[2]}) {
    necked.cutter.flute_length_mm = 4;
    necked.cutter.shank = {{2, 3}, {4, 20}};
    out.push_back(necked);
  }
  return out;
}

/// A wave of hollows, hills and slopes up to some 50°.
model::Cage wave_cage(std::mt19937& random) {
  std::uniform_real_distribution<double> height(-1.2, 1.2);
  return grid_cage(
      7, 7,
      [&](int i, int j) {
        return Vec3{2.0 * i - 7, 2.0 * j - 7, height(random)};
      },
      model::BoundaryRule::none);
}

Cutter drawn(const Uncertain& tool, std::mt19937& random) {
  const auto in = [&](const Interval& r) {
    return std::uniform_real_distribution(r.low, r.high)(random);
  };
  model::CutterOffset by{in(tool.by.radius_mm), 0, in(tool.by.corner_radius_mm), {}};
  if (tool.by.flat_mm) by.flat_mm = in(*tool.by.flat_mm);
  return model::varied(tool.cutter, by);
}

Tolerances tolerances_of(const Uncertain& tool) {
  Tolerances t;
  t.tools[tool.cutter.id] = tool.by;
  return t;
}

}  // namespace

TEST_CASE("what any cutter of a box of tolerances touches, its smallest one touches",
          "[property][reach]") {
  std::mt19937 random(5);
  int touched = 0, out_of_reach = 0;
  for (int k = 0; k < by_effort(4, 40); ++k) {
    const ReferenceSurface surface(wave_cage(random));
    const SurfaceCells cells(surface.tree(), 0.5);
    for (const Uncertain& tool : uncertain_cutters()) {
      const std::vector<Pass> passes{
          {tool.cutter, shared(raster(1, 1, 1, [](double, double) { return 9.0; }))}};
      const auto least = ToleranceBox(tolerances_of(tool), passes).smallest_cutters();
      REQUIRE(least);
      const Reachability smallest(cells, least->front().cutter, 0.1, kContact_mm);
      const Reachability one(cells, drawn(tool, random), 0.1, kContact_mm);
      CAPTURE(to_text(tool.cutter), to_text(least->front().cutter));
      for (std::size_t i = 0; i < cells.cells().size(); i += 7) {
        const SurfaceCell& cell = cells.cells()[i];
        const auto at = surface.evaluate(cell.patch, cell.u_at(0.5), cell.v_at(0.5));
        const bool is_touched = one.touching_tip(at.position, at.normal).has_value();
        touched += is_touched ? 1 : 0;
        if (is_touched) CHECK(smallest.touching_tip(at.position, at.normal));
        if (!smallest.touching_tip(at.position, at.normal)) ++out_of_reach;
      }
    }
  }
  // Both happen, so that neither is trivial.
  CHECK(touched > 100);
  CHECK(out_of_reach > 100);
}

TEST_CASE("a leftover that only the smallest cutter of its tolerances reaches counts",
          "[unit][reach]") {
  // Rows over a bowl that stay 0.3 above its lowest place. A ball of 4.5 does not get down there,
  // one of 3 does.
  constexpr double kBend = 0.15, kLeft_mm = 0.3;
  const ReferenceSurface bowl(paraboloid_cage(3, kBend));
  const auto over = [=](double x, double y) {
    const double r2 = x * x + y * y;
    return kBend * r2 + kLeft_mm * std::max(0.0, 1 - r2);
  };
  const model::Stock block = model::BoxStock{{-60, -60, -60}, {120, 120, 120}};
  StageCheck check;
  check.resolution_mm = 0.005;
  check.field_spacing_mm = 1;
  const auto uncut_of = [&](double radius_mm, bool tolerant) {
    check.tolerances.reset();
    if (tolerant) check.tolerances.emplace().tools["ball"].radius_mm = {-1.5, 0};
    const std::vector<Pass> passes{{ball_cutter(radius_mm), shared(raster(4, 0.25, 0.25, over))}};
    const StageDeviation d = measure_stage(bowl, block, passes, nullptr, check, {2});
    return tolerant ? d.robust->uncut.figure_mm : d.uncut_mm;
  };
  const Interval whole = uncut_of(4.5, true), stated = uncut_of(4.5, false);
  const Interval smallest = uncut_of(3, false);
  CAPTURE(whole.low, whole.high, stated.low, stated.high, smallest.low, smallest.high);
  CHECK(smallest.low == Approx(kLeft_mm).margin(0.01));
  CHECK(stated.high < kLeft_mm - 0.02);
  CHECK(whole.high >= smallest.low);
  CHECK(whole.low >= smallest.low - check.resolution_mm);
  for (const double radius_mm : {3.4, 4.0}) CHECK(uncut_of(radius_mm, false).low <= whole.high);
}

}  // namespace limitgauge::verifier
