// Drills, APT cutters with a rising bottom, and cutters whose side leans inwards: figures in closed
// form, and what is left undecided because no proof covers it.
#include <numbers>
#include <random>

#include "tests/support/cages.h"
#include "tests/support/catch.h"
#include "tests/support/rasters.h"
#include "verifier/certificate/unavoidable.h"
#include "verifier/cutter/swept_body.h"
#include "verifier/gate/verify.h"
#include "verifier/surface/reference_surface.h"

namespace limitgauge::verifier {
namespace {

using model::Vec3;
using namespace tests;

const model::Stock kPointedBlock = model::BoxStock{{-60, -60, -60}, {120, 120, 120}};
constexpr double kPointedResolution_mm = 0.001;

StageDeviation measure_pointed(const ReferenceSurface& surface, const model::Cutter& cutter,
                               model::Toolpath path, double allowance_mm = 0) {
  const Pass pass{cutter, shared(std::move(path))};
  StageCheck check;
  check.resolution_mm = kPointedResolution_mm;
  check.allowance_mm = allowance_mm;
  check.field_spacing_mm = 1;
  return measure_stage(surface, kPointedBlock, {&pass, 1}, nullptr, check, {2});
}

/// The closed form lies in the interval, which is no wider than was asked for.
void check_interval(const Interval& interval, double truth_mm) {
  CAPTURE(interval.low, interval.high, truth_mm);
  CHECK(interval.low <= truth_mm + 1e-9);
  CHECK(interval.high >= truth_mm - 1e-9);
  CHECK(interval.width() <= kPointedResolution_mm + 1e-9);
}

/// The height of the cusps over a plane at the angle β, along its normal, that rows along its
/// contours leave, `step` apart in plan, whose sharp tips run on the plane between sides that rise
/// at the angle a. Against the plane the side of the row below rises at a − β and that of the row
/// above at a + β; the tips are step / cos β apart on it, and the sides meet at the cusp.
double tip_rows(double a, double beta, double step) {
  const double lower = std::tan(a - beta), upper = std::tan(a + beta);
  return step / std::cos(beta) * lower * upper / (lower + upper);
}

}  // namespace

TEST_CASE("rows of sharp tips on planes leave what formulas say", "[slow]") {
  for (const double slope : {0.0, 0.3}) {
    const ReferenceSurface plane(plane_cage(2, slope, 0));
    for (const char* text : {"drill:D=6,angle=118,L=60", "apt:D=8,r=1,a=31,b=5,L=60"}) {
      CAPTURE(slope, text);
      const double a = 31 * std::numbers::pi / 180, beta = std::atan(slope), step = 0.4;
      const auto tip = [&](double x, double) { return slope * x; };
      const auto d = measure_pointed(plane, model::parse_cutter(text), raster(6, step, 6, tip));
      check_interval(d.uncut_mm, tip_rows(a, beta, step));
      CHECK(d.gouge_mm.low == 0);
      CHECK(d.gouge_mm.high <= kPointedResolution_mm);
      // The tip touches all of the plane.
      CHECK(d.unreachable_area_mm2 == Approx(0).margin(1e-9));
    }
  }
}

TEST_CASE("a plane steeper than the point is touched by the drill's corner", "[unit]") {
  const double slope = 1;
  const ReferenceSurface plane(plane_cage(2, slope, 0));
  const auto drill = model::parse_cutter("drill:D=6,angle=118,L=60");
  const double corner = 3 * std::tan(31 * std::numbers::pi / 180), over = 0.02;
  // The corner is 3 mm uphill of the tip and stands `over` higher than the plane.
  const auto tip = [&](double x, double) { return slope * (x + 3) - corner + over; };
  // Rows in the direction of the slope: the corners run along lines `step` apart, each a straight
  // one in the plane's direction, lifted off it; the circles of the corner bend away from it.
  const double step = 0.2;
  model::Toolpath path;
  path.start = {-9, -4, tip(-9, 0)};
  for (int row = 0; row <= 40; ++row) {
    const double y = -4 + row * step, near = row % 2 ? 5 : -9, far = row % 2 ? -9 : 5;
    feed_to(path, {near, y, tip(near, 0)});
    feed_to(path, {far, y, tip(far, 0)});
  }
  const auto d = measure_pointed(plane, drill, path);
  // Under the rows the corner is over / √2 off. Between two of them its circle, seen along the
  // slope, is an ellipse: higher by less than (step/2)²/(2·3)·(slope), and there the distance grows
  // by no more than that over √2.
  const double bend = step * step / 4 / (2 * 3) * slope;
  CHECK(d.uncut_mm.low >= over / std::sqrt(2) - 1e-9);
  CHECK(d.uncut_mm.high <= (over + 1.01 * bend) / std::sqrt(2) + kPointedResolution_mm);
  CHECK(d.gouge_mm.high <= kPointedResolution_mm);
}

TEST_CASE("drilled holes gouge a plane as deep as their tips go", "[unit]") {
  const ReferenceSurface plane(plane_cage(5, 0, 0));
  const auto drill = model::parse_cutter("drill:D=3,angle=118,L=60");
  const double depth = 0.5;
  model::Toolpath path;
  path.start = {-3, -3, 5};
  for (int k = 0; k < 9; ++k) {
    const double x = 3.0 * (k % 3) - 3, y = 3.0 * (k / 3) - 3;
    for (const double z : {5.0, k == 4 ? -depth : -depth / 2, 5.0}) feed_to(path, {x, y, z});
  }
  const auto d = measure_pointed(plane, drill, path);
  // Straight down from the plane to the tip of the deepest hole; its cone rises from there.
  check_interval(d.gouge_mm, depth);
  REQUIRE(!d.gouges.empty());
  CHECK(std::hypot(d.gouges.front().place.point.x, d.gouges.front().place.point.y) < 0.1);
}

TEST_CASE("a cutter whose side leans inwards, over a plane and with an allowance", "[unit]") {
  const ReferenceSurface plane(plane_cage(5, 0, 0));
  const auto dovetail = model::parse_cutter("apt:D=8,r=0.5,b=-30,L=5");
  for (const double height : {0.05, -0.03}) {
    const auto d = measure_pointed(
        plane, dovetail, raster(12, 3, 12, [&](double, double) { return 0.1 + height; }), 0.1);
    check_interval(d.uncut_mm, std::max(0.0, height));
    check_interval(d.gouge_mm, std::max(0.0, -height));
  }
}

TEST_CASE("positions that touch are the allowance away, for every cutter", "[property]") {
  std::mt19937 random(31);
  std::uniform_real_distribution<double> part(-1, 1);
  const ReferenceSurface plane(plane_cage(5, 0, 0));
  const SurfaceCells cells(plane.tree(), 1);
  for (const char* text :
       {"flat:D=6", "bull:D=6,r=1", "taper:D=4,r=1,angle=20,L=30", "drill:D=6,angle=118,L=30",
        "drill:D=6,angle=90,L=30", "apt:D=8,r=1,a=10,b=5,L=30", "apt:D=6,r=6,a=45,L=30",
        "apt:D=10,r=2,b=-10,L=9", "apt:D=10,r=1,a=15,b=-40,L=6"}) {
    const CutterProfile profile(model::parse_cutter(text));
    const Reachability reach(cells, profile, 0.1, 1e-4);
    int touched = 0;
    for (int n = 0; n < 200; ++n) {
      const Vec3 normal = normalized(Vec3{part(random), part(random), std::abs(part(random))});
      const Vec3 p{part(random), part(random), part(random)};
      const auto tip = reach.contact_tip(p, normal);
      if (!tip) continue;
      ++touched;
      CAPTURE(text, normal.x, normal.y, normal.z);
      const BodyDistance d = standing_distance(profile, *tip, p);
      CHECK(d.value == Approx(0.1).margin(1e-12));
      // The cutter faces the plane of contact: the way out of it is against the normal.
      CHECK(distance(d.gradient, -normal) < 1e-9);
    }
    CHECK(touched > 50);
  }
}

TEST_CASE("a plane as steep as the point is touched all along it", "[unit]") {
  const double slope = std::tan(31 * std::numbers::pi / 180);
  const ReferenceSurface plane(plane_cage(5, slope, 0));
  const SurfaceCells cells(plane.tree(), 1);
  const Vec3 normal = normalized(Vec3{-slope, 0, 1});
  for (const char* text : {"drill:D=6,angle=118,L=30", "apt:D=8,r=1,a=31,b=5,L=30"}) {
    const CutterProfile profile(model::parse_cutter(text));
    const Reachability reach(cells, profile, 0, 1e-4);
    CHECK_FALSE(reach.contact_tip({0, 0, 0}, normal));
    const auto tip = reach.touching_tip({0, 0, 0}, normal);
    REQUIRE(tip);
    CHECK(standing_distance(profile, *tip, {0, 0, 0}).value == Approx(0).margin(1e-12));
  }
}

TEST_CASE("cells proven out of a drill's reach hold no place it touches", "[property]") {
  // In the bowl z = 0.05·r² a drill of 24 mm rests on its corner: nothing within can be touched.
  const ReferenceSurface bowl(paraboloid_cage(24, 0.05));
  const SurfaceCells cells(bowl.tree(), 0.5);
  const Reachability reach(cells, CutterProfile(model::parse_cutter("drill:D=24,angle=160,L=60")),
                           0, 1e-4);
  int by_tip = 0, by_corner = 0;
  for (std::size_t k = 0; k < cells.cells().size(); k += 7) {
    const SurfaceCell& cell = cells.cells()[k];
    if (!reach.surely_unreachable(offset_cell(cell.shape, {}))) continue;
    const Vec3 m = middle(cell.shape);
    CAPTURE(m.x, m.y);
    CHECK_FALSE(reach.touching_tip(m, middle_normal(cell)));
    // The bowl is as steep as the point at r = 10·tan(10°).
    (std::hypot(m.x, m.y) < 1.763 ? by_tip : by_corner) += 1;
  }
  CHECK(by_tip > 0);
  CHECK(by_corner > 20);
}

TEST_CASE("nothing is proven out of an undercutting cutter's reach", "[unit]") {
  const ReferenceSurface cube(cube_cage());
  const SurfaceCells cells(cube.tree(), 0.1);
  const CutterProfile dovetail(model::parse_cutter("apt:D=2,r=0.1,b=-30,L=1.5"));
  const Reachability reach(cells, dovetail, 0, 1e-4);
  for (const SurfaceCell& cell : cells.cells())
    CHECK_FALSE(reach.surely_unreachable(offset_cell(cell.shape, {})));
  const ReachMap map = classify_reach(cells, reach, {0.05, 1}, {2});
  CHECK(map.unreachable_area_mm2() == 0);
  // The endless cutter still proves what it touches from above.
  CHECK(reach.touching_tip(cube.evaluate(1, 0.5, 0.5).position, {0, 0, 1}));
  CHECK_FALSE(reach.touching_tip(cube.evaluate(0, 0.5, 0.5).position, {0, 0, -1}));
}

/// In the groove z = m·|x|, rounded for |x| < h so that its bottom is at m·h/3 (see
/// unavoidable_test), the corner of a drill of radius R rests on both sides: tip = m·R − R·tan a.
TEST_CASE("unavoidable uncut of a drill in a groove is bracketed", "[property]") {
  constexpr double m = 0.8, h = 2, contact = 1e-4;
  const auto cage = profile_cage(8, 8, [](double x) { return m * std::abs(x); });
  const auto left = m * 3 - 3 * std::tan(5 * std::numbers::pi / 180) - m * h / 3;
  const ReferenceSurface surface(cage);
  const SurfaceCells cells(surface.tree(), 0.5);
  const UnavoidableOptions options;
  for (const bool undercuts : {false, true}) {
    const auto cutter =
        model::parse_cutter(undercuts ? "apt:D=6,a=5,b=-10,L=9" : "drill:D=6,angle=170,L=60");
    const Reachability reach(cells, CutterProfile(cutter), 0, contact);
    const ReachMap map = classify_reach(cells, reach, {0.3, 50'000}, {2});
    const Unavoidable u = unavoidable_uncut(cells, map, reach, {}, cutter, options, {2});
    CAPTURE(undercuts, left, u.uncut_mm.low, u.uncut_mm.high);
    // The contact tolerance lets the corner sink by that much.
    CHECK(u.uncut_mm.high >= left - std::sqrt(1 + m * m) * contact);
    CHECK(u.uncut_mm.low <= left);
    if (undercuts) {
      CHECK(u.uncut_mm.low == 0);  // undecided: the endless cutter decides nothing from below
    } else {
      CHECK(u.uncut_mm.width() <= std::max(options.resolution_mm, options.share * left * 1.1));
    }
  }
}

}  // namespace limitgauge::verifier
