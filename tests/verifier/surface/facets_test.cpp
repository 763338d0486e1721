// A mesh as the design: its facets are the surface, and everything said of them must be what is
// said of a cage that is sharp everywhere.
#include <cmath>
#include <random>

#include "model/part/target_mesh.h"
#include "tests/support/catch.h"
#include "tests/support/effort.h"
#include "tests/support/judging.h"
#include "verifier/surface/surface_tree.h"

namespace limitgauge::verifier {
namespace {

using model::TriangleMesh;
using model::Vec3;
using namespace tests;

/// A rectangle of columns × rows squares of two triangles each, at random heights.
TriangleMesh random_ground(std::mt19937& random, int columns, int rows, double pitch_mm,
                           double height_mm) {
  std::uniform_real_distribution<double> height(0, height_mm), shift(-0.2, 0.2);
  TriangleMesh mesh;
  for (int j = 0; j <= rows; ++j)
    for (int i = 0; i <= columns; ++i)
      mesh.vertices.push_back(
          {(i + shift(random)) * pitch_mm, (j + shift(random)) * pitch_mm, height(random)});
  const auto at = [&](int i, int j) { return static_cast<std::uint32_t>(j * (columns + 1) + i); };
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) {
      mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  return mesh;
}

/// Rows of a cutter over the ground at random heights: some too deep, some too high.
model::Toolpath random_rows(std::mt19937& random, const TriangleMesh& mesh, double step_mm) {
  const model::Box3 box = bounding_box(mesh);
  std::uniform_real_distribution<double> lift(-0.3, 0.8);
  std::vector<Vec3> tips;
  for (double y = box.low.y; y <= box.high.y; y += step_mm)
    for (int k = 0; k <= 4; ++k) {
      const double x = box.low.x + box.size().x * k / 4;
      tips.push_back({x, y, box.high.z + lift(random)});
    }
  return moves_through(tips);
}

bool meet(const Interval& a, const Interval& b) {
  return a.low <= b.high && b.low <= a.high;
}

model::Cutter random_cutter(std::mt19937& random) {
  switch (random() % 3) {
    case 0:
      return ball_cutter(0.5 + 0.1 * static_cast<double>(random() % 10));
    case 1:
      return flat_cutter(2);
    default:
      return {"bull", model::CutterType::bull, 3, 0.5, 0, 30, {}, {}};
  }
}

}  // namespace

TEST_CASE("facets: patches are numbered and placed as those of the cage that is sharp everywhere",
          "[unit][facets]") {
  std::mt19937 random(7);
  const TriangleMesh mesh = random_ground(random, 4, 3, 2, 1.5);
  const ReferenceSurface facets(mesh), limit(model::faceted_cage(mesh));
  REQUIRE(facets.patch_count() == 3 * static_cast<int>(mesh.triangles.size()));
  REQUIRE(limit.patch_count() == facets.patch_count());
  for (int patch = 0; patch < facets.patch_count(); ++patch)
    for (const double u : {0.0, 1.0})
      for (const double v : {0.0, 1.0}) {
        const SurfaceSample a = facets.evaluate(patch, u, v), b = limit.evaluate(patch, u, v);
        CHECK(distance(a.position, b.position) < 1e-12);
        // Within a facet parameters differ, the plane does not.
        CHECK(std::abs(dot(limit.evaluate(patch, 0.3, 0.6).position - a.position, a.normal)) <
              1e-12);
      }
  CHECK(distance(facets.bounding_box().low, limit.bounding_box().low) < 1e-9);
  CHECK(distance(facets.bounding_box().high, limit.bounding_box().high) < 1e-9);
  CHECK(std::abs(facets.area_mm2() - area_mm2(mesh)) < 1e-9 * area_mm2(mesh));
}

TEST_CASE("facets: a ball above a flat facet leaves and a ball below gouges what was planted",
          "[unit][facets][definition2]") {
  TriangleMesh mesh;
  mesh.vertices = {{-10, -10, 0}, {10, -10, 0}, {10, 10, 0}, {-10, 10, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  const ReferenceSurface surface(mesh);
  const auto block = block_between({-10, -10, -5}, {10, 10, 3});
  // One flat cutter as wide as the part, 0.02 mm too deep, then 0.05 mm too high.
  for (const double z : {-0.02, 0.05}) {
    const std::vector<Pass> passes = {
        pass_of(flat_cutter(30), moves_through({{-30, 0, z}, {30, 0, z}}))};
    const StageDeviation d = measured(surface, block, passes, 1e-3);
    const double gouge = std::max(0.0, -z), uncut = std::max(0.0, z);
    CAPTURE(z, d.gouge_mm.low, d.gouge_mm.high, d.uncut_mm.low, d.uncut_mm.high);
    CHECK(d.gouge_mm.low <= gouge + 1e-6);
    CHECK(d.gouge_mm.high >= gouge - 1e-6);
    CHECK(d.gouge_mm.width() <= 1e-3);
    CHECK(d.uncut_mm.low <= uncut + 1e-6);
    CHECK(d.uncut_mm.high >= uncut - 1e-6);
    CHECK(d.uncut_mm.width() <= 1e-3);
  }
}

TEST_CASE("facets: a mesh and the cage that is sharp everywhere agree within their intervals",
          "[property][slow][facets][definition2]") {
  const auto seeds = static_cast<unsigned>(by_effort(6, 20));
  for (unsigned seed = 1; seed <= seeds; ++seed) {
    std::mt19937 random(seed);
    const TriangleMesh mesh = random_ground(random, 2, 2, 2, 1.2);
    const ReferenceSurface facets(mesh), limit(model::faceted_cage(mesh));
    const model::Box3 box = bounding_box(mesh);
    const auto block = block_between(box.low - Vec3{0, 0, 2}, box.high + Vec3{0, 0, 1});
    const std::vector<Pass> passes = {
        pass_of(random_cutter(random), random_rows(random, mesh, 0.7))};
    const StageDeviation a = measured(facets, block, passes, 0.02),
                         b = measured(limit, block, passes, 0.02);
    CAPTURE(seed, a.gouge_mm.low, a.gouge_mm.high, b.gouge_mm.low, b.gouge_mm.high, a.uncut_mm.low,
            a.uncut_mm.high, b.uncut_mm.low, b.uncut_mm.high);
    CHECK(meet(a.gouge_mm, b.gouge_mm));
    CHECK(meet(a.uncut_mm, b.uncut_mm));
    CHECK(meet(a.missing_stock_mm, b.missing_stock_mm));
    // Not merely by being wide.
    CHECK(a.gouge_mm.width() <= std::max(0.04, 1.01 * b.gouge_mm.width()));
  }
}

TEST_CASE("facets: an upright wall is in reach of what runs along it, all of it",
          "[unit][facets][reach]") {
  // The cutter's straight side touches it over its height, and the facets are bent by rounding
  // alone.
  const double lean = GENERATE(0.0, 1.7e-4);
  const ReferenceSurface wall(
      TriangleMesh{{{-10, -10 - lean, -5}, {10, -10 - lean, -5}, {10, -10, 5}, {-10, -10, 5}},
                   {{0, 1, 2}, {0, 2, 3}}});
  const auto cutter = GENERATE(flat_cutter(4), ball_cutter(4),
                               model::Cutter{"bull", model::CutterType::bull, 8, 1, 0, 30, {}, {}});
  const std::vector<Pass> passes = {
      pass_of(cutter, moves_through({{-20, -14.0, 20}, {-20, -14, -10}, {20, -14, -10}}))};
  const StageDeviation d = measured(wall, block_between({-15, -15, -5}, {15, 15, 7}), passes, 0.01);
  CAPTURE(lean, d.proven_reach.reachable_mm2, d.proven_reach.undecided_mm2);
  CHECK(d.proven_reach.reachable_mm2 == Approx(200).margin(0.5));
  CHECK(d.proven_reach.undecided_mm2 <= 0.5);
  CHECK(d.uncut_mm.high <= 0.01);
}

TEST_CASE("facets: a mesh that is no two-manifold is refused", "[unit][facets]") {
  TriangleMesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}};
  mesh.triangles = {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}};
  CHECK_THROWS_AS(ReferenceSurface(mesh), std::invalid_argument);
}

}  // namespace limitgauge::verifier
