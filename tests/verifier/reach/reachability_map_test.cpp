#include "tests/support/cages.h"
#include "tests/support/catch.h"
#include "tests/support/part_cages.h"
#include "tests/support/rasters.h"
#include "verifier/reach/reach_map.h"
#include "verifier/surface/reference_surface.h"

namespace limitgauge::verifier {
namespace {

using namespace tests;

constexpr double kTrough = 0.05, kRadius = 12, kHalf = 20;

/// How deep a ball that touches the trough at x cuts into its other side, by search.
double cut_by_ball(double x) {
  const double steep = std::sqrt(1 + 4 * kTrough * kTrough * x * x);
  const double cx = x - kRadius * 2 * kTrough * x / steep, cz = kTrough * x * x + kRadius / steep;
  double nearest = 1e300;
  for (double at = -kHalf; at < 0; at += 1e-3)
    nearest = std::min(nearest, std::hypot(at - cx, kTrough * at * at - cz));
  return kRadius - nearest;
}

/// Where contacts begin to cut by more than `contact_mm`: beyond it the ball fits.
double contact_edge(double contact_mm) {
  double low = 1, high = kHalf;
  for (int n = 0; n < 40; ++n) {
    const double x = (low + high) / 2;
    (cut_by_ball(x) > contact_mm ? low : high) = x;
  }
  return high;
}

/// Length of the parabola over [0, x].
double arc(double x) {
  const double m = 2 * kTrough * x;
  return (m * std::sqrt(1 + m * m) + std::asinh(m)) / (4 * kTrough);
}

}  // namespace

TEST_CASE("certified areas of a trough that a ball does not fit bracket the closed form",
          "[property]") {
  const ReferenceSurface surface(trough_cage(kHalf, kTrough));
  const SurfaceCells cells(surface.tree(), 1);
  const double contact = 1e-3;
  const double edge = contact_edge(contact);
  // Resting on both sides at x₀ the ball cuts into neither: R = √(1 + 4k²x₀²)/(2k).
  const double resting = std::sqrt(4 * kTrough * kTrough * kRadius * kRadius - 1) / (2 * kTrough);
  CHECK(edge == Approx(resting).margin(0.01));
  const double out_of_reach = 2 * arc(edge) * 2 * kHalf;
  const Reachability reach(cells, CutterProfile(ball_cutter(kRadius)), 0, contact);
  double last = 1e300;
  for (const double smallest : {0.5, 0.25, 0.125}) {
    const ReachMap map = classify_reach(cells, reach, {smallest, 200'000}, {2});
    // Quadrature of the cells and of the whole agree to 1e-6 of the area.
    const double area = surface.area_mm2(), rounding = 1e-6 * area;
    CHECK(map.reachable_area_mm2() + map.unreachable_area_mm2() + map.undecided_area_mm2() ==
          Approx(area).margin(rounding));
    CHECK(map.unreachable_area_mm2() <= out_of_reach + rounding);
    CHECK(map.reachable_area_mm2() <= area - out_of_reach + rounding);
    CHECK(map.undecided_area_mm2() < 0.8 * last);
    last = map.undecided_area_mm2();
  }
  CHECK(last < 0.03 * surface.area_mm2());
}

TEST_CASE("a ball that hardly notices a surface's bend reaches it whole, irregular vertices too",
          "[property]") {
  for (const int valence : {3, 5, 12}) {
    const ReferenceSurface surface(star_cage(valence, 1));
    const SurfaceCells cells(surface.tree(), first_cell_radius_mm(surface.tree()));
    const Reachability reach(cells, CutterProfile(ball_cutter(1)), 0, 1e-4);
    const ReachMap map = classify_reach(cells, reach, {0.1, 200'000}, {2});
    CHECK(map.unreachable_area_mm2() == 0);
    // Beside the vertex and the rim no disc is wide enough, and a rectangle's bounds are wide.
    CHECK(map.undecided_area_mm2() < (valence == 12 ? 0.02 : 0.01) * surface.area_mm2());
  }
}

TEST_CASE("the underside of a closed surface is out of reach, to half its area", "[property]") {
  const ReferenceSurface cube(cube_cage());
  const SurfaceCells cells(cube.tree(), 0.2);
  const Reachability reach(cells, CutterProfile(ball_cutter(1)), 0, 1e-3);
  const ReachMap map = classify_reach(cells, reach, {0.008, 100'000}, {2});
  const double half = cube.area_mm2() / 2, rounding = 1e-6 * half;
  CHECK(map.reachable_area_mm2() <= half + rounding);
  CHECK(map.unreachable_area_mm2() <= half + rounding);
  CHECK(map.undecided_area_mm2() < 0.1 * half);
  CHECK(map.unreachable_area_mm2() > 0.9 * half);
  CHECK(map.at(0, 0.5, 0.5) == Reach::unreachable);
  CHECK(map.at(1, 0.5, 0.5) == Reach::reachable);
}

TEST_CASE("a slot as wide as its flat is in reach, and one that is narrower is not", "[property]") {
  const double kContact = 1e-4, kDeep = 5;
  // Wider than the cutter by nothing, by what a sliding fit has, and by a tenth.
  for (const double wider : {0.0, 0.02, 0.1}) {
    CAPTURE(wider);
    const double half = 3 + wider / 2;
    const ReferenceSurface slot(
        drawn_outline({{-half, 0}, {-half, -kDeep}, {half, -kDeep}, {half, 0}}, 10));
    const SurfaceCells cells(slot.tree(), 1);
    const Reachability reach(cells, CutterProfile(flat_cutter(3)), 0, kContact);
    const ReachMap map = classify_reach(cells, reach, {0.1, 20'000}, {2});
    CHECK(map.unreachable_area_mm2() == 0);
    // Floor whose chord of the cutter is shorter than a cell stays open, and cells at the rims.
    CHECK(map.undecided_area_mm2() < 0.06 * slot.area_mm2());
  }
  const double half = 3 - 4 * kContact;
  const ReferenceSurface slot(
      drawn_outline({{-half, 0}, {-half, -kDeep}, {half, -kDeep}, {half, 0}}, 10));
  const SurfaceCells cells(slot.tree(), 1);
  const Reachability reach(cells, CutterProfile(flat_cutter(3)), 0, kContact);
  // From the ends it reaches a radius in.
  CHECK(classify_reach(cells, reach, {0.1, 20'000}, {2}).reachable_area_mm2() <
        0.25 * slot.area_mm2());
}

TEST_CASE("reach maps agree with single contacts and do not depend on threads", "[slow]") {
  const ReferenceSurface surface(star_cage(5, 4));
  const SurfaceCells cells(surface.tree(), 1);
  for (const model::Cutter& cutter : {ball_cutter(6), flat_cutter(3)}) {
    const Reachability reach(cells, CutterProfile(cutter), 0.2, 1e-3);
    const ReachMap map = classify_reach(cells, reach, {0.3, 20'000}, {1});
    const ReachMap again = classify_reach(cells, reach, {0.3, 20'000}, {3});
    CHECK(map.entries().size() == again.entries().size());
    CHECK(map.reachable_area_mm2() == again.reachable_area_mm2());
    CHECK(map.unreachable_area_mm2() == again.unreachable_area_mm2());
    int proven = 0;
    for (std::size_t k = 0; k < map.entries().size(); k += 11) {
      const auto& entry = map.entries()[k];
      // Cells of a level vertex below a nanometre are level to rounding: there the map may place
      // the flat anywhere, a single contact follows the rounding's direction.
      if (entry.reach == Reach::undecided || entry.area_mm2 < 1e-10) continue;
      const BezierJet j = jet(cells.cell_of(entry.cell).shape, 0.3, 0.8);
      const model::Vec3 normal = normalized(cross(j.du, j.dv));
      CHECK(reach.touching_tip(j.position, normal).has_value() ==
            (entry.reach == Reach::reachable));
      ++proven;
    }
    CHECK(proven > 50);
  }
}

}  // namespace limitgauge::verifier
