#include "verifier/reach/graph_region.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "tests/support/cages.h"
#include "tests/support/catch.h"
#include "tests/support/feature_cages.h"
#include "tests/support/part_cages.h"
#include "tests/support/rasters.h"
#include "verifier/surface/reference_surface.h"

namespace limitgauge::verifier {
namespace {

using namespace tests;
using model::Vec3;

/// A surface, its cells, and regions round contacts of a ball.
struct Scene {
  explicit Scene(const model::Cage& cage, double cell_mm = 0.5, double ball_mm = 3)
      : surface(cage),
        cells(surface.tree(), cell_mm),
        index(cells.cells()),
        charts(cells.cells(), index),
        regions(cells.cells(), index, charts),
        ball(ball_cutter(ball_mm)) {}

  std::optional<CellContact> contact(std::uint32_t k) const {
    return CellContact::of(offset_cell(cells.cells()[k].shape, {}), ball, 0);
  }
  std::optional<GraphRegion> around(std::uint32_t k, double widest_mm) const {
    const auto touching = contact(k);
    return touching ? regions.around(*touching, k, widest_mm, 1e300) : std::nullopt;
  }
  std::uint32_t cell_near(const Vec3& p) const {
    std::uint32_t best = 0;
    for (std::uint32_t k = 0; k < cells.cells().size(); ++k)
      if (distance(middle(cells.cells()[k].shape), p) <
          distance(middle(cells.cells()[best].shape), p))
        best = k;
    return best;
  }

  ReferenceSurface surface;
  SurfaceCells cells;
  ParameterIndex index;
  PatchCharts charts;
  GraphRegions regions;
  CutterProfile ball;
};

/// Points of a cell, with its corners.
std::vector<Vec3> points_of(const SurfaceCell& cell) {
  std::vector<Vec3> out;
  for (int k = 0; k < 25; ++k)
    out.push_back(jet(cell.shape, (k % 5) / 4.0, (k / 5) / 4.0).position);
  return out;
}

/// Holds what a region says of its discs against points of S and of the contact's cell. Gives how
/// many points were looked at.
int check_heights(const Scene& scene, const GraphRegion& region, double radius_mm) {
  const auto disc = region.over(radius_mm);
  if (!disc) return 0;
  const SurfaceCell& own = scene.cells.cells()[region.cells.front().index];
  int looked = 0;
  for (const double at : {0.0, 0.4, 1.0}) {
    const BezierJet j = jet(own.shape, at, 1 - at);
    const Vec3 n = normalized(cross(j.du, j.dv));
    for (const GraphRegion::Cell& cell : region.cells)
      for (const Vec3& q : points_of(scene.cells.cells()[cell.index])) {
        const Vec3 w = q - j.position;
        const double height = dot(w, n), aside = length(w - n * height);
        CHECK(aside >= cell.near_mm);
        CHECK(length(w) <= cell.far_mm);
        CHECK(w.z <= cell.rise_mm);
        if (aside >= radius_mm) continue;
        CHECK(height <= disc->bend * aside * aside / 2 + 1e-9);
        ++looked;
      }
  }
  return looked;
}

}  // namespace

TEST_CASE("over a disc no height is above what the bend allows", "[property][reach]") {
  std::mt19937 random(5);
  int looked = 0;
  for (const model::Cage& cage :
       {paraboloid_cage(8, 0.03), trough_cage(8, 0.1), scaled(cube_cage(), 8), star_cage(3, 2),
        star_cage(5, 2), star_cage(12, 1), scaled(prism(5), 6),
        boss_cage({{-5, -5, 0}, {5, 5, 6}})}) {
    const Scene scene(cage);
    for (int round = 0; round < 25; ++round) {
      const auto k = static_cast<std::uint32_t>(random() % scene.cells.cells().size());
      const auto region = scene.around(k, 3);
      if (!region) continue;
      for (const double share : {0.5, 0.8, 1.0})
        looked += check_heights(scene, *region, share * region->limit_mm);
    }
  }
  CHECK(looked > 100'000);
}

TEST_CASE("the bend of a trough is its parabola's", "[unit][reach]") {
  constexpr double kSteep = 0.05;
  const Scene scene(trough_cage(20, kSteep));
  const auto region = scene.around(scene.cell_near({0.2, 0, 0}), 4);
  REQUIRE(region);
  CHECK(region->limit_mm == 4);
  const auto disc = region->over(4);
  REQUIRE(disc);
  // z = k·x² has the second derivative 2·k over its own plane.
  CHECK(disc->bend >= 2 * kSteep);
  // Cells at its rim lie 22 degrees over, at a cosine whose cube is 0.8.
  CHECK(disc->bend < 1.3 * 2 * kSteep);
  // Seen from above it is a crest.
  const Scene crest(trough_cage(20, -kSteep));
  const auto over = crest.around(crest.cell_near({0, 0, 0}), 4);
  REQUIRE(over);
  CHECK(over->over(4).value().bend < 0.02 * 2 * kSteep);
}

TEST_CASE("a region ends where S does, and at an irregular vertex", "[unit][reach]") {
  const Scene plane(plane_cage(10, 0, 0));
  const double edge_mm = 10;
  const auto beside = plane.around(plane.cell_near({edge_mm - 3, 0, 0}), 8);
  REQUIRE(beside);
  CHECK(beside->limit_mm > 1);
  CHECK(beside->limit_mm <= 3.5);
  CHECK(plane.around(plane.cell_near({0, 0, 0}), 6).value().limit_mm == 6);
  // At the edge itself there is no disc.
  CHECK(!plane.around(plane.cell_near({edge_mm, 0, 0}), 8));

  const Scene star(star_cage(5, 0));
  const Vec3 vertex = star.surface.evaluate(0, 0, 0).position;
  for (std::uint32_t k = 0; k < star.cells.cells().size(); ++k) {
    const auto region = star.around(k, 5);
    if (!region) continue;
    const double away_mm = distance(middle(star.cells.cells()[k].shape), vertex);
    CHECK(region->limit_mm <= away_mm + 0.5);
  }
}

TEST_CASE("a disc is no part of a sheet that lies over another", "[unit][reach]") {
  // A cell at the middle of a narrow slot's floor: as far as the walls' normals let it go.
  const Scene box(boss_cage({{-4, -4, 0}, {4, 4, 0.5}}), 0.3);
  const auto region = box.around(box.cell_near({0, 0, 0.5}), 3);
  REQUIRE(region);
  for (const GraphRegion::Cell& cell : region->cells)
    CHECK(middle(box.cells.cells()[cell.index].shape).z > 0.2);
}

TEST_CASE("patches go on round an irregular vertex, sector by sector", "[unit][reach]") {
  for (const int valence : {3, 5, 12}) {
    const Scene star(star_cage(valence, 1));
    for (int patch = 0; patch < valence; ++patch) {
      int beside = 0;
      for (const PlacedPatch& placed : star.charts.around(patch))
        beside += std::abs(placed.at_u) + std::abs(placed.at_v) == 1;
      CHECK(beside >= 2);
    }
  }
}

}  // namespace limitgauge::verifier
