#include "verifier/cells/surface_crossing.h"

#include <cmath>
#include <numbers>

#include "tests/support/catch.h"
#include "tests/support/feature_cages.h"
#include "tests/support/part_cages.h"
#include "verifier/surface/reference_surface.h"

namespace limitgauge::verifier {
namespace {

using model::Vec3;
using namespace tests;

/// How far segments that begin on S look past it.
constexpr double kPast_mm = 4e-6;
constexpr double kDegree = std::numbers::pi / 180;

/// A ridge of 60 degrees at (0, h) on a floor, along Y.
constexpr double kHeight_mm = 2;
std::vector<OutlinePoint> ridge() {
  const double half = kHeight_mm * std::tan(30 * kDegree);
  return {{-4, 0}, {-half, 0}, {0, kHeight_mm}, {half, 0}, {4, 0}};
}

SurfaceCells cells_of(const model::Cage& cage) {
  return SurfaceCells(ReferenceSurface(cage).tree(), 0.25);
}

}  // namespace

TEST_CASE("beside an acute edge the other face is met after as much as the tangent says",
          "[unit][definition2]") {
  const SurfaceCells cells = cells_of(drawn_outline(ridge(), 6));
  // Down the left flank from the edge by d, inwards: the right flank after d·tan 60°.
  const Vec3 down{-std::sin(30 * kDegree), 0, -std::cos(30 * kDegree)},
      normal{-std::cos(30 * kDegree), 0, std::sin(30 * kDegree)};
  for (const double d : {1e-7, 1e-6, 1e-5, 1e-3, 0.5}) {
    CAPTURE(d);
    const Vec3 s = Vec3{0, 0.3, kHeight_mm} + down * d;
    const double found = next_crossing_mm(cells, s, normal, Way::inwards, 0, 5);
    CHECK(found <= d * std::tan(60 * kDegree) + 1e-9);
    // What is met is known to the size of the smallest cells, and better where s itself is near.
    CHECK(found >= d * std::tan(60 * kDegree) - (d > 5e-6 ? 4e-6 : 1e-8));
    CHECK(next_crossing_mm(cells, s, normal, Way::outwards, 0, 1) == 1);
  }
}

TEST_CASE("through a ridge the other flank is met wherever a ray begins", "[unit][definition2]") {
  const SurfaceCells cells = cells_of(drawn_outline(ridge(), 6));
  const Vec3 down{-std::sin(30 * kDegree), 0, -std::cos(30 * kDegree)};
  for (int k = 0; k < 2000; ++k) {
    // Level, from one flank to the other.
    const double d = 0.1 + k * 1.0007e-3;
    const Vec3 s = Vec3{0, 0.3 + k * 1e-4, kHeight_mm} + down * d;
    CAPTURE(k);
    CHECK(next_crossing_mm(cells, s, {-1, 0, 0}, Way::inwards, 0, 5) == Approx(d).margin(4e-6));
  }
}

TEST_CASE("a ray that keeps close to a face does not meet it", "[unit][definition2]") {
  const SurfaceCells cells = cells_of(drawn_outline(ridge(), 6));
  // Along the right flank, level and upwards, and along the floor up to the flank.
  const Vec3 out{std::cos(30 * kDegree), 0, std::sin(30 * kDegree)},
      up{-std::sin(30 * kDegree), 0, std::cos(30 * kDegree)};
  for (const double d : {1e-3, 1e-5, 1e-7}) {
    CAPTURE(d);
    const Vec3 s = Vec3{0.6, 0.3, kHeight_mm - 0.6 / std::tan(30 * kDegree)} + out * d;
    CHECK(next_crossing_mm(cells, s, {0, 1, 0}, Way::outwards, 0, 2) == 2);
    CHECK(next_crossing_mm(cells, s, up, Way::outwards, 0, 8) == 8);
    CHECK(next_crossing_mm(cells, {4 - 1e-3, 0.3, d}, {-1, 0, 0}, Way::outwards, 0, 8) ==
          Approx(4 - 1e-3 - (kHeight_mm - d) * std::tan(30 * kDegree)).margin(4e-6));
  }
}

TEST_CASE("on an edge the faces that meet there are no crossing", "[unit][definition2]") {
  const SurfaceCells cells = cells_of(drawn_outline(ridge(), 6));
  for (const double lean : {-50.0, -20.0, 0.0, 35.0}) {
    const Vec3 n{std::sin(lean * kDegree), 0, std::cos(lean * kDegree)};
    CHECK(next_crossing_mm(cells, {0, 0.3, kHeight_mm}, n, Way::outwards, 0, 1) == 1);
  }
}

TEST_CASE("that all runs of a cell cross the surface is proven where they do, and only there",
          "[unit][definition2]") {
  const double tangent = std::tan(60 * kDegree);
  const SurfaceCells cells = cells_of(drawn_outline(ridge(), 6));
  std::size_t tried = 0;
  for (const SurfaceCell& cell : cells.cells()) {
    const OffsetCell offset = offset_cell(cell.shape, cell.vertex_normal);
    if (offset.normal.x > -0.5) continue;  // the left flank
    double nearest = 1e300, furthest = 0;
    bool at_end = false;
    for (int k = 0; k < 16; ++k) {
      const Vec3 p = cell.shape.control(k);
      const double d = (kHeight_mm - p.z) / std::cos(30 * kDegree);
      nearest = std::min(nearest, d), furthest = std::max(furthest, d);
      at_end = at_end || std::abs(p.y) > 3 - 1e-6;
    }
    if (at_end || furthest > 1.1) continue;  // what meets the floor
    ++tried;
    CHECK_FALSE(surely_crosses_surface(cells, offset, Way::inwards, -(furthest - 1e-3) * tangent,
                                       kPast_mm));
    CHECK_FALSE(
        surely_crosses_surface(cells, offset, Way::inwards, -nearest * tangent / 2, kPast_mm));
    CAPTURE(nearest, furthest, offset.middle.y);
    CHECK(surely_crosses_surface(cells, offset, Way::inwards, -(furthest * tangent + 1e-3),
                                 kPast_mm));
  }
  CHECK(tried > 20);
}

TEST_CASE("across a slot the far wall ends the runs, above it nothing does",
          "[unit][definition2]") {
  const Slot slot{3, 2, 4, 6};
  const SurfaceCells cells = cells_of(slot_cage(slot));
  std::size_t walls = 0, proven = 0;
  for (const SurfaceCell& cell : cells.cells()) {
    const OffsetCell offset = offset_cell(cell.shape, cell.vertex_normal);
    double end = 0, high = -9, low = 9;
    for (int k = 0; k < 16; ++k) {
      const Vec3 p = cell.shape.control(k);
      end = std::max(end, std::abs(p.y)), high = std::max(high, p.z), low = std::min(low, p.z);
    }
    if (std::abs(offset.normal.x) < 0.9 || end > 3 - 1e-6) {
      // From floor and tops nothing is met outwards.
      CHECK_FALSE(surely_crosses_surface(cells, offset, Way::outwards, -kPast_mm, 2.9));
      continue;
    }
    ++walls;
    CHECK_FALSE(
        surely_crosses_surface(cells, offset, Way::outwards, -kPast_mm, slot.width_mm - 1e-3));
    // Rows of cells at the very top and floor touch the edges of the far wall.
    if (high > -1e-6 || low < -slot.depth_mm + 1e-6) continue;
    CHECK(surely_crosses_surface(cells, offset, Way::outwards, -kPast_mm, slot.width_mm + 1e-3));
    // Begun beyond the place itself, as with an allowance.
    CHECK(surely_crosses_surface(cells, offset, Way::outwards, 0.2, slot.width_mm + 1e-3));
    ++proven;
  }
  CHECK(walls > proven);
  CHECK(proven > 20);
}

TEST_CASE("a sheet that faces as the first does, next to it, ends no run behind it",
          "[unit][definition2]") {
  // 2 to 300 nm apart: whichever lies in front, there is a run of 2 mm behind it.
  const double apart = GENERATE(2e-6, 1e-4, 3e-4), way = GENERATE(-1.0, 1.0);
  CAPTURE(apart, way);
  const model::Cage plane = plane_cage(3, 0, 0);
  const SurfaceCells cells =
      cells_of(together(plane, placed(plane_cage(3, 0, 0), {1, 0, {0, 0, way * apart}})));
  for (const SurfaceCell& cell : cells.cells()) {
    const OffsetCell offset = offset_cell(cell.shape, cell.vertex_normal);
    const bool behind = offset.middle.z < std::max(0.0, way * apart) - apart / 2;
    CHECK_FALSE(
        surely_crosses_surface(cells, offset, Way::inwards, behind ? -2 : -apart / 2, kPast_mm));
    CHECK_FALSE(
        surely_crosses_surface(cells, offset, Way::outwards, behind ? -kPast_mm : -apart / 2, 2));
  }
}

TEST_CASE("a far face in front ends no run that goes the other way", "[unit][definition2]") {
  // A slit of 0.2 micrometres: its roof faces down. Runs into the floor do not meet it, runs out
  // of it do.
  const double slit = 2e-4;
  const SurfaceCells cells = cells_of(
      together(plane_cage(3, 0, 0), flipped(placed(plane_cage(3, 0, 0), {1, 0, {0, 0, slit}}))));
  std::size_t crossed = 0;
  for (const SurfaceCell& cell : cells.cells()) {
    const OffsetCell offset = offset_cell(cell.shape, cell.vertex_normal);
    CHECK_FALSE(surely_crosses_surface(cells, offset, Way::inwards, -2, kPast_mm));
    crossed += surely_crosses_surface(cells, offset, Way::outwards, -kPast_mm, 2);
  }
  CHECK(crossed > cells.cells().size() / 4);
}

TEST_CASE("a run that meets the surface again and again ends at the first", "[unit][definition2]") {
  // A floor over a closed hollow over nothing: runs down meet its roof after 1 mm, its floor after
  // 1.5 mm.
  const model::Cage plane = plane_cage(3, 0, 0);
  const auto sheet = [&](double z) { return placed(plane, {1, 0, {0, 0, z}}); };
  const SurfaceCells cells = cells_of(together(together(plane, flipped(sheet(-1))), sheet(-1.5)));
  std::size_t tried = 0;
  for (const SurfaceCell& cell : cells.cells()) {
    const OffsetCell offset = offset_cell(cell.shape, cell.vertex_normal);
    double end = 0;
    for (int k = 0; k < 16; ++k) {
      const Vec3 p = cell.shape.control(k);
      end = std::max({end, std::abs(p.x), std::abs(p.y)});
    }
    // Beside the rims of the sheets nothing is proven.
    if (offset.normal.z < 0 || offset.middle.z < -1e-3 || end > 3 - 1e-6) continue;
    ++tried;
    CHECK_FALSE(surely_crosses_surface(cells, offset, Way::inwards, -0.99, kPast_mm));
    CHECK(surely_crosses_surface(cells, offset, Way::inwards, -1.2, kPast_mm));
    CHECK(surely_crosses_surface(cells, offset, Way::inwards, -4, kPast_mm));
    // Runs up from the floor meet nothing.
    CHECK_FALSE(surely_crosses_surface(cells, offset, Way::outwards, -kPast_mm, 4));
  }
  CHECK(tried > 20);
}

TEST_CASE("sheets back to back in one place are a fin of no width, and its runs have none",
          "[unit][definition2]") {
  const bool back_to_back = GENERATE(true, false);
  CAPTURE(back_to_back);
  const model::Cage plane = plane_cage(3, 0, 0);
  const SurfaceCells cells = cells_of(together(plane, back_to_back ? flipped(plane) : plane));
  for (const Way way : {Way::outwards, Way::inwards})
    CHECK(next_crossing_mm(cells, {0.3, 0.4, 0}, {0, 0, 1}, way, 0, 2) ==
          Approx(back_to_back ? 0 : 2).margin(4e-9));
  for (const SurfaceCell& cell : cells.cells()) {
    const OffsetCell offset = offset_cell(cell.shape, cell.vertex_normal);
    if (!back_to_back)
      CHECK_FALSE(surely_crosses_surface(cells, offset, Way::inwards, -2, kPast_mm));
  }
}

}  // namespace limitgauge::verifier
