// The raw stock as a triangle mesh: the same figures as a block or a bar where it is one, and
// closed forms where it is not.
#include "tests/support/cages.h"
#include "tests/support/catch.h"
#include "tests/support/rasters.h"
#include "tests/support/solid_meshes.h"
#include "verifier/certificate/leftover_regions.h"
#include "verifier/gate/findings.h"

namespace limitgauge::verifier {
namespace {

using model::Vec3;
using namespace tests;

constexpr double kResolution_mm = 0.0005;

/// A pass through the air above everything.
model::Toolpath in_the_air() {
  return raster(5, 1, 10, [](double, double) { return 20.0; });
}

StageDeviation measure(const ReferenceSurface& surface, const model::Stock& stock,
                       model::Toolpath path, double allowance_mm = 0, GateLimits limits = {},
                       unsigned threads = 2) {
  const Pass pass{ball_cutter(3), shared(std::move(path))};
  StageCheck check;
  check.resolution_mm = kResolution_mm;
  check.allowance_mm = allowance_mm;
  check.field_spacing_mm = 1;
  check.limits = limits;
  return measure_stage(surface, stock, {&pass, 1}, nullptr, check, {threads});
}

/// Both certify the same truth, and neither is wider than it was asked to be; a figure beyond its
/// limit need only be known to a twentieth of itself.
void check_alike(const Interval& a, const Interval& b) {
  CAPTURE(a.low, a.high, b.low, b.high);
  CHECK(a.low <= b.high + 1e-9);
  CHECK(b.low <= a.high + 1e-9);
  CHECK(b.width() <= std::max({a.width(), kResolution_mm, 0.05 * a.low}));
}

/// Findings that are more than rounding: S in a face of the stock is a leftover of 1e-16 mm or
/// none.
std::ptrdiff_t counted(const std::vector<Finding>& findings) {
  return std::count_if(findings.begin(), findings.end(),
                       [](const Finding& f) { return f.depth_mm > 1e-9; });
}

}  // namespace

TEST_CASE("a mesh of a block has the block's figures and verdict", "[unit]") {
  const ReferenceSurface plane(plane_cage(5, 0, 0)), slope(plane_cage(5, 0.02, 0.01));
  struct Case {
    const char* name;
    const ReferenceSurface& surface;
    double top_mm;
    double allowance_mm;
    model::Toolpath path;
  };
  const auto rows = raster(5, 0.2, 5, [](double, double) { return 0.0; });
  const auto half = raster(3, 0.5, 3, [](double, double) { return 0.02; });
  const Case cases[] = {{"deep", plane, 40, 0, rows},
                        {"half cut", plane, 0.4, 0, half},
                        {"too low", plane, -0.02, 0, in_the_air()},
                        {"flush", plane, 0, 0, in_the_air()},
                        {"not cut", plane, 0.4, 0, in_the_air()},
                        {"less than the allowance", plane, 0.15, 0.2, rows},
                        {"through the face", slope, 0.05, 0, in_the_air()}};
  for (const Case& c : cases) {
    CAPTURE(c.name);
    const Vec3 low{-7, -8, -9}, size{14, 16, 9 + c.top_mm};
    const GateLimits limits{true, true, false, 0.01, 0.05, 0};
    const auto block =
        measure(c.surface, model::BoxStock{low, size}, c.path, c.allowance_mm, limits);
    const auto mesh =
        measure(c.surface, mesh_stock(box_mesh(low, size)), c.path, c.allowance_mm, limits);
    check_alike(block.gouge_mm, mesh.gouge_mm);
    check_alike(block.uncut_mm, mesh.uncut_mm);
    check_alike(block.missing_stock_mm, mesh.missing_stock_mm);
    CHECK(decide(block, limits).verdict == decide(mesh, limits).verdict);
    CHECK(counted(block.gouges) == counted(mesh.gouges));
    CHECK(counted(block.uncuts) == counted(mesh.uncuts));
    CHECK(block.field.samples.size() == mesh.field.samples.size());
    for (std::size_t i = 0; i < block.field.samples.size(); ++i)
      REQUIRE(block.field.samples[i].deviation_mm ==
              Approx(mesh.field.samples[i].deviation_mm).margin(1e-6));
    UNSCOPED_INFO(c.name << ": " << block.cells << " cells, with the mesh " << mesh.cells);
    CHECK(mesh.cells < 3 * block.cells + 3000);
  }
}

TEST_CASE("a face of a mesh at a slant is measured as exactly as a level one", "[unit]") {
  const ReferenceSurface slope(plane_cage(5, 0.75, 0));
  for (const double over_mm : {0.05, 0.0, -0.03}) {
    // A block whose upper face stands so far over S, turned as S is.
    const auto block = mapped(box_mesh({-20, -20, -9}, {40, 40, 9 + over_mm}), [](const Vec3& p) {
      return Vec3{0.8 * p.x - 0.6 * p.z, p.y, 0.6 * p.x + 0.8 * p.z};
    });
    const auto d = measure(slope, mesh_stock(block), in_the_air());
    CAPTURE(over_mm);
    CHECK(d.uncut_mm.low == Approx(std::max(0.0, over_mm)).margin(1e-7));
    CHECK(d.uncut_mm.high == Approx(std::max(0.0, over_mm)).margin(kResolution_mm));
    // No motion took away what was never there.
    CHECK(d.missing_stock_mm.low == Approx(std::max(0.0, -over_mm)).margin(1e-7));
    CHECK(d.missing_stock_mm.high == Approx(std::max(0.0, -over_mm)).margin(kResolution_mm));
    CHECK(d.gouge_mm.low == 0);
    CHECK(d.gouge_mm.high <= kResolution_mm);
    CHECK(d.cells < 20'000);
  }
}

TEST_CASE("a mesh of a bar with many sides has the bar's figures", "[slow]") {
  // The corners of S stand 5·√2 − 6 mm out of the bar; there the polygon has corners too. Under
  // them nothing ever stands: what is missing goes deeper than the bar is high.
  const ReferenceSurface plane(plane_cage(5, 0, 0));
  const auto mesh = measure(plane, mesh_stock(prism_mesh({0, 0, -8}, 6, 8.3, 720)), in_the_air());
  const auto bar = measure(plane, model::CylinderStock{{0, 0, -8}, 12, 8.3}, in_the_air());
  CHECK(mesh.missing_stock_mm.low > 8.3);
  check_alike(bar.missing_stock_mm, mesh.missing_stock_mm);
  CHECK(mesh.gouge_mm.low == 0);
  CHECK(mesh.gouge_mm.high <= kResolution_mm);
  CHECK(mesh.uncut_mm.low == Approx(0.3).margin(kResolution_mm));
  check_alike(bar.uncut_mm, mesh.uncut_mm);
  REQUIRE(!mesh.missing_stock.empty());
  CHECK(mesh.missing_stock.front().raw_stock);
}

TEST_CASE("where a casting has a pocket too deep, raw stock is missing", "[unit]") {
  // The pocket's floor lies 0.3 mm below the top, its walls slope over 0.5 mm; S lies 0.1 mm below.
  const auto top = [](double x, double y) {
    return std::abs(x) < 2.1 && std::abs(y) < 2.1 ? -0.3 : 0.0;
  };
  const model::Stock casting = mesh_stock(block_under(8, 32, -6, top));
  const ReferenceSurface plane(plane_cage(5, 0, 0)),
      lower(profile_cage(4, 5, [](double) { return -0.1; }));
  const GateLimits limits{true, true, false, 0.05, 0.12, 0};
  const auto d = measure(lower, casting, in_the_air(), 0, limits);
  CHECK(d.missing_stock_mm.low == Approx(0.2).margin(kResolution_mm));
  CHECK(d.missing_stock_mm.high == Approx(0.2).margin(0.01));
  CHECK(d.missing_stock_mm.high >= 0.2 - 1e-9);
  CHECK(d.gouge_mm.low == 0);
  CHECK(d.gouge_mm.high <= kResolution_mm);
  CHECK(d.uncut_mm.low == Approx(0.1).margin(kResolution_mm));
  CHECK(d.uncut_mm.high == Approx(0.1).margin(kResolution_mm));
  CHECK(decide(d, limits).verdict == Verdict::fail);
  CHECK(d.gouges.empty());
  REQUIRE(d.missing_stock.size() == 1);
  CHECK(d.missing_stock.front().raw_stock);
  CHECK(d.findings_complete);
  // Deeper than 0.05 straight under S: up to where the wall, which rises from 2 to 2.5 mm, is 0.15
  // mm below the top, to the size of the cells that the edge is found with.
  const double half = d.missing_stock.front().extent_mm.size().x / 2;
  CHECK(half == Approx(2.25).margin(0.02));
  // The same casting, of which all that counts is milled away.
  const auto rows = raster(5, 0.2, 5, [](double, double) { return -0.35; });
  const ReferenceSurface deep(profile_cage(4, 5, [](double) { return -0.35; }));
  const auto milled = measure(deep, casting, rows, 0, limits);
  CHECK(milled.gouge_mm.low == 0);
  CHECK(milled.gouge_mm.high <= kResolution_mm);
  CHECK(milled.missing_stock_mm.high <= kResolution_mm);
  CHECK(milled.uncut_mm.high < 3 - std::sqrt(9 - 0.01) + kResolution_mm);  // the scallop
}

TEST_CASE("under half of the part there is no stock at all", "[unit]") {
  // S reaches from −5 to 5 and the block ends at x = 0. Beyond that a run straight down meets none
  // of it, so that it is longer than the block's 12 mm.
  const ReferenceSurface plane(plane_cage(5, 0, 0));
  const auto d = measure(plane, mesh_stock(box_mesh({-9, -9, -9}, {9, 18, 12})), in_the_air());
  CHECK(d.missing_stock_mm.low > 12);
  CHECK(d.gouge_mm.low == 0);
  CHECK(d.gouge_mm.high <= kResolution_mm);
  REQUIRE(!d.missing_stock.empty());
  CHECK(d.missing_stock.front().raw_stock);
  CHECK(d.missing_stock.front().place.point.x > 0);
  CHECK(d.missing_stock.front().area_mm2 == Approx(50).epsilon(0.02));
  // Nothing of it is there at all.
  const auto gone = measure(plane, mesh_stock(box_mesh({30, -9, -9}, {9, 18, 12})), in_the_air());
  CHECK(gone.missing_stock_mm.low > 12);
  CHECK(gone.uncut_mm.high <= kResolution_mm);
}

TEST_CASE("what is left of a mesh is found as what is left of a block", "[unit]") {
  const ReferenceSurface plane(plane_cage(5, 0, 0));
  const Pass pass{ball_cutter(3), shared(raster(3, 0.5, 3, [](double, double) { return 0.0; }))};
  LeftoverRequest request;
  request.cutter = ball_cutter(1);
  request.threshold_mm = 0.05;
  const Vec3 low{-7, -8, -9}, size{14, 16, 9.4};
  const auto block =
      find_leftover_regions(plane, model::BoxStock{low, size}, {&pass, 1}, request, {2});
  const auto mesh =
      find_leftover_regions(plane, mesh_stock(box_mesh(low, size)), {&pass, 1}, request, {2});
  CHECK(block.area_mm2 > 1);
  CHECK(mesh.area_mm2 == Approx(block.area_mm2).epsilon(0.02));
  CHECK(mesh.boxes.size() == block.boxes.size());
  CHECK(mesh.complete);
}

}  // namespace limitgauge::verifier
