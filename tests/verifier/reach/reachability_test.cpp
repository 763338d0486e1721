#include "verifier/reach/reachability.h"

#include "tests/support/cages.h"
#include "tests/support/catch.h"
#include "tests/support/part_cages.h"
#include "tests/support/rasters.h"
#include "verifier/gate/verify.h"
#include "verifier/surface/reference_surface.h"

namespace limitgauge::verifier {
namespace {

using model::Vec3;
using namespace tests;

/// The bowl z = k·r²: a ball of R > 1/(2k) touches on the circle r² = R² − 1/(4k²) at the deepest
/// and leaves (2kR − 1)²/(4k) on the axis.
constexpr double kBowl = 0.05, kBallRadius = 12;
const double kContactCircle = std::sqrt(kBallRadius * kBallRadius - 1 / (4 * kBowl * kBowl));

Vec3 bowl_point(double x, double y) {
  return {x, y, kBowl * (x * x + y * y)};
}
Vec3 bowl_normal(double x, double y) {
  return normalized(Vec3{-2 * kBowl * x, -2 * kBowl * y, 1});
}

}  // namespace

TEST_CASE("a ball too large for a bowl reaches down to the contact circle", "[unit]") {
  const ReferenceSurface bowl(paraboloid_cage(24, kBowl));
  const SurfaceCells cells(bowl.tree(), 0.5);
  const Reachability reach(cells, CutterProfile(ball_cutter(kBallRadius)), 0, 1e-4);
  for (const double angle : {0.0, 0.7, 2.9}) {
    const double c = std::cos(angle), s = std::sin(angle);
    // Contact tolerance 1e-4 mm: the penetration grows with the square of the distance inwards.
    const double in = 0.9 * kContactCircle, out = 1.02 * kContactCircle;
    CHECK_FALSE(reach.touching_tip(bowl_point(in * c, in * s), bowl_normal(in * c, in * s)));
    CHECK(reach.touching_tip(bowl_point(out * c, out * s), bowl_normal(out * c, out * s)));
  }
  const Reachability small(cells, CutterProfile(ball_cutter(3)), 0, 1e-4);
  CHECK(small.touching_tip({0, 0, 0}, {0, 0, 1}));
  const Reachability with_allowance(cells, CutterProfile(ball_cutter(9.5)), 1, 1e-4);
  CHECK_FALSE(with_allowance.touching_tip({0, 0, 0}, {0, 0, 1}));
}

TEST_CASE("what a large ball leaves in a bowl is unavoidable and not the toolpath's fault",
          "[slow]") {
  const ReferenceSurface bowl(paraboloid_cage(24, kBowl));
  // The ball rolls in the bowl as deep as it goes: its centre on the axis at the lowest, else
  // touching.
  const auto tip = [](double x, double y) {
    const double r = std::hypot(x, y);
    const double lowest = (kBowl * kContactCircle * kContactCircle) + 1 / (2 * kBowl) - kBallRadius;
    if (r < 1e-9) return lowest;
    // Least height at which the ball centred over (x, y) clears the bowl, by search over contacts.
    double z = -1e300;
    for (double c = -23; c <= 23; c += 0.01) {
      const double across = c - r;
      if (std::abs(across) > kBallRadius) continue;
      z = std::max(
          z, kBowl * c * c + std::sqrt(kBallRadius * kBallRadius - across * across) - kBallRadius);
    }
    return z;
  };
  const Pass pass{ball_cutter(kBallRadius), shared(raster(12, 1.5, 1.5, tip))};
  StageCheck check;
  check.resolution_mm = 0.01;
  check.field_spacing_mm = 0.5;
  const model::Stock block = model::BoxStock{{-60, -60, -60}, {120, 120, 120}};
  const StageDeviation d = measure_stage(bowl, block, {&pass, 1}, nullptr, check, {2});
  const double left = std::pow(2 * kBowl * kBallRadius - 1, 2) / (4 * kBowl);
  CHECK(d.unavoidable_uncut_mm.low <= left);
  CHECK(d.unavoidable_uncut_mm.high >= left);
  CHECK(d.unavoidable_uncut_mm.width() <= 0.01);
  const double flat_disc = kContactCircle * kContactCircle * 3.14159265;
  // The disc inside the contact circle, measured on the bowl: a little more than in plan; the field
  // resolves the rim to its spacing.
  CHECK(d.unreachable_area_mm2 > 0.9 * flat_disc);
  CHECK(d.unreachable_area_mm2 < 1.6 * flat_disc);
}

TEST_CASE("undersides cannot be touched, walls can by a straight cutter only", "[unit]") {
  const ReferenceSurface cube(cube_cage());
  const SurfaceCells cells(cube.tree(), 0.1);
  const Reachability ball(cells, CutterProfile(ball_cutter(1)), 0, 1e-4);
  CHECK_FALSE(ball.touching_tip(cube.evaluate(0, 0.5, 0.5).position, {0, 0, -1}));
  CHECK(ball.touching_tip(cube.evaluate(1, 0.5, 0.5).position, {0, 0, 1}));
  const SurfaceSample side = cube.evaluate(2, 0.5, 0.5);
  CHECK(side.normal.z == Approx(0).margin(1e-12));
  const Reachability taper(
      cells, CutterProfile({"t", model::CutterType::taper, 1, 0.5, 5, 20, {}, {}}), 0, 1e-4);
  CHECK_FALSE(taper.touching_tip(side.position, side.normal));
}

TEST_CASE("a flat stands on a floor that is level but for the contact tolerance", "[unit]") {
  // The floor falls towards a wall: the point of it that is 0.5 mm in front of the wall is touched
  // by what stands behind it, the rest of the flat being no deeper than 6 mm times the slope.
  const double slope = GENERATE(0.0, 1e-7, 1e-6, 1e-5, 1e-3);
  const ReferenceSurface step(drawn_outline({{-4, 14 * slope}, {10, 0}, {10, 5}, {14, 5}}, 10));
  const SurfaceCells cells(step.tree(), 0.1);
  const Reachability flat(cells, CutterProfile(flat_cutter(3)), 0, 1e-4);
  const Vec3 p{9.5, 0, 0.5 * slope}, n = normalized(Vec3{slope, 0, 1});
  const bool is_level = 6 * slope < 1e-4;
  CAPTURE(slope);
  CHECK(flat.touching_tip(p, n).has_value() == is_level);
  Bezier spot;
  for (int k = 0; k < 16; ++k) spot.set(k, p);
  CHECK(flat.surely_unreachable(offset_cell(spot, n, 0)) == !is_level);
}

TEST_CASE("a wall that leans over by less than the contact tolerance is in reach", "[unit]") {
  const double lean = GENERATE(0.0, 1e-7, 1e-6, 1e-5, 1e-3);
  const ReferenceSurface boss(drawn_outline({{-5, 4}, {5, 4}, {5 - 4 * lean, 0}, {12, 0}}, 10));
  const SurfaceCells cells(boss.tree(), 0.1);
  const Reachability flat(cells, CutterProfile(flat_cutter(3)), 0, 1e-4);
  const Vec3 p{5 - 2 * lean, 0, 2}, n = normalized(Vec3{1, 0, -lean});
  const bool is_upright = 2 * lean < 1e-4;
  CAPTURE(lean);
  CHECK(flat.touching_tip(p, n).has_value() == is_upright);
  Bezier spot;
  for (int k = 0; k < 16; ++k) spot.set(k, p);
  CHECK(flat.surely_unreachable(offset_cell(spot, n, 0)) == !is_upright);
  // Between the normals of a sharp edge none is rounding.
  CHECK(flat.surely_unreachable(offset_cell(spot, n, 0), nullptr, NormalOf::edge) == (lean > 0));
}

TEST_CASE("a neck and the flutes below it are one body", "[unit]") {
  // Below the floor by next to nothing the flutes alone would cut it by no more, and the neck,
  // which begins there, by as little.
  const ReferenceSurface step(drawn_outline({{-6, 0}, {0.5, 0}, {0.5, -1.5}, {6, -1.5}}, 8));
  const SurfaceCells cells(step.tree(), 0.1);
  const double neck_mm = GENERATE(1.75, 2.4, 0.5);
  const double flutes_mm = GENERATE(4.0, 0.6);
  model::Cutter bull{"bull", model::CutterType::bull, 2.5, 0.5, 0, flutes_mm, {}, {}};
  bull.shank = {{neck_mm, 30}};
  CAPTURE(neck_mm, flutes_mm);
  const Reachability reach(cells, bull, 0, 1e-4);
  CHECK(reach.touching_tip({0.5, 0, -0.9}, {1, 0, 0}));
  CHECK_FALSE(reach.touching_tip({0.5, 0, -1.2}, {1, 0, 0}));
  CHECK_FALSE(reach.touching_tip({0.5, 0, -1.49995}, {1, 0, 0}));
}

TEST_CASE("the top edge of a taper may touch what its side does not", "[unit]") {
  const ReferenceSurface cube(cube_cage());
  const SurfaceCells cells(cube.tree(), 0.1);
  const SurfaceSample side = cube.evaluate(2, 0.5, 0.5);
  Bezier spot;
  for (int k = 0; k < 16; ++k) spot.set(k, side.position);
  const OffsetCell wall = offset_cell(spot, side.normal, 0);
  model::Cutter taper{"taper", model::CutterType::taper, 0.2, 0, 25, 0.1, {}, {}};
  CHECK(Reachability(cells, taper, 0, 1e-4).surely_unreachable(wall));
  taper.shank = {{0.2 + 2 * 0.1 * std::tan(25 * 3.14159265358979 / 180) + 1e-9, 30}};
  CHECK_FALSE(Reachability(cells, taper, 0, 1e-4).surely_unreachable(wall));
  // A shank that sticks out over them cuts the wall before they do.
  taper.shank.front().diameter_mm += 0.1;
  CHECK(Reachability(cells, taper, 0, 1e-4).surely_unreachable(wall));
}

TEST_CASE("normal cones hold the normals of their cell", "[property]") {
  const ReferenceSurface surface(star_cage(7, 5));
  const SurfaceCells cells(surface.tree(), 0.8);
  int cones = 0;
  for (const SurfaceCell& cell : cells.cells()) {
    const OffsetCell cone = offset_cell(cell.shape, {});
    if (cone.spread_rad >= std::numbers::pi) continue;
    ++cones;
    for (double s = 0; s <= 1; s += 0.25)
      for (double t = 0; t <= 1; t += 0.25) {
        const BezierJet j = jet(cell.shape, s, t);
        const double cosine = dot(normalized(cross(j.du, j.dv)), cone.normal);
        CHECK(std::acos(std::min(1.0, cosine)) <= cone.spread_rad + 1e-6);
      }
  }
  CHECK(cones > 100);
}

}  // namespace limitgauge::verifier
