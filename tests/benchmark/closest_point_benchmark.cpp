// Nearest points on the exact limit surface against CGAL's AABB tree on the same surface as
// triangles, two for each of 128 × 128 quads a patch (depth 7). Same points, same run.

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Simple_cartesian.h>
#include <benchmark/benchmark.h>

#include <cmath>
#include <random>
#include <vector>

#include "model/part/cage_obj.h"
#include "tests/benchmark/dome_finish.h"
#include "tests/support/cages.h"
#include "tests/support/folders.h"
#include "verifier/feet/closest_point.h"
#include "verifier/surface/reference_surface.h"

namespace limitgauge::benchmarks {
namespace {

using model::Vec3;

using Kernel = CGAL::Simple_cartesian<double>;
using Triangles = std::vector<Kernel::Triangle_3>;
using Primitive = CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>;
using TriangleTree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;

constexpr int kQuads = 128;
constexpr std::size_t kQueries = 4096;

Kernel::Point_3 cgal_point(const Vec3& p) {
  return {p.x, p.y, p.z};
}

Triangles tessellate(const verifier::ReferenceSurface& surface) {
  Triangles out;
  for (int patch = 0; patch < surface.patch_count(); ++patch) {
    if (!surface.has_surface(patch)) continue;
    const auto at = [&](int i, int j) {
      return cgal_point(
          surface.evaluate(patch, static_cast<double>(i) / kQuads, static_cast<double>(j) / kQuads)
              .position);
    };
    for (int j = 0; j < kQuads; ++j)
      for (int i = 0; i < kQuads; ++i) {
        const auto a = at(i, j), b = at(i + 1, j), c = at(i + 1, j + 1), d = at(i, j + 1);
        out.emplace_back(a, b, c);
        out.emplace_back(a, c, d);
      }
  }
  return out;
}

/// Points off the surface along its normals on both sides, up to `off_mm`; 0 for a mixture, one
/// half within 0.5 mm and the other within 20 mm.
std::vector<Vec3> queries(const verifier::ReferenceSurface& surface, double off_mm) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> part(0, 1), side(-1, 1);
  std::vector<Vec3> out;
  while (out.size() < kQueries) {
    const int patch = static_cast<int>(random() % static_cast<unsigned>(surface.patch_count()));
    if (!surface.has_surface(patch)) continue;
    const auto s = surface.evaluate(patch, part(random), part(random));
    const double reach = off_mm > 0 ? off_mm : out.size() % 2 == 0 ? 0.5 : 20;
    out.push_back(s.position + s.normal * (side(random) * reach));
  }
  return out;
}

model::Cage cage_of(int which) {
  if (which == 0) return tests::paraboloid_cage(30, -kBend);
  return model::read_cage_obj(tests::fixtures() / "cages/aircraft.obj");
}

void closest_point_exact(benchmark::State& state) {
  const verifier::ReferenceSurface surface(cage_of(static_cast<int>(state.range(0))));
  const verifier::SurfaceCells cells(surface.tree(), 1);
  const std::vector<Vec3> points = queries(surface, static_cast<double>(state.range(1)) / 1000);
  for (auto _ : state)
    for (const Vec3& p : points) benchmark::DoNotOptimize(closest_point(cells, p, 1000));
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(points.size()));
  state.counters["tree_bytes"] = static_cast<double>(cells.feet().memory_bytes());
}

void closest_points_batch(benchmark::State& state) {
  const verifier::ReferenceSurface surface(cage_of(static_cast<int>(state.range(0))));
  const verifier::SurfaceCells cells(surface.tree(), 1);
  const std::vector<Vec3> points = queries(surface, static_cast<double>(state.range(1)) / 1000);
  for (auto _ : state)
    benchmark::DoNotOptimize(closest_points(cells, points, 1000, {2, nullptr, {}}));
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(points.size()));
}

/// The corners of CGAL's triangle are on the surface: none may be nearer than our answer.
bool beats_corners(const verifier::SurfaceCells& cells, const TriangleTree& tree, const Vec3& p) {
  const auto found = closest_point(cells, p, 1000);
  const auto q = cgal_point(p);
  const Kernel::Triangle_3& t = *tree.closest_point_and_primitive(q).second;
  for (int k = 0; k < 3; ++k)
    if (!found || found->distance_mm > std::sqrt(CGAL::squared_distance(t[k], q)) + 1e-9)
      return false;
  return true;
}

void closest_point_cgal_aabb(benchmark::State& state) {
  const verifier::ReferenceSurface surface(cage_of(static_cast<int>(state.range(0))));
  const Triangles triangles = tessellate(surface);
  TriangleTree tree(triangles.begin(), triangles.end());
  tree.build();
  tree.accelerate_distance_queries();
  const std::vector<Vec3> points = queries(surface, static_cast<double>(state.range(1)) / 1000);
  for (auto _ : state)
    for (const Vec3& p : points) benchmark::DoNotOptimize(tree.closest_point(cgal_point(p)));
  const verifier::SurfaceCells cells(surface.tree(), 1);
  for (const Vec3& p : points)
    if (!beats_corners(cells, tree, p)) state.SkipWithError("a corner of a triangle is nearer");
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(points.size()));
}

/// 0: the paraboloid dome, 1: the aircraft; with the greatest distance in micrometres, 0 for the
/// mixture.
void cases(benchmark::internal::Benchmark* b) {
  for (const int surface : {0, 1})
    for (const int off_um : {0, 500}) b->Args({surface, off_um});
  b->Unit(benchmark::kMillisecond);
}
void mixtures(benchmark::internal::Benchmark* b) {
  b->Args({0, 0})->Args({1, 0})->Unit(benchmark::kMillisecond)->UseRealTime();
}
BENCHMARK(closest_point_exact)->Apply(cases);
BENCHMARK(closest_point_cgal_aabb)->Apply(cases);
BENCHMARK(closest_points_batch)->Apply(mixtures);

}  // namespace
}  // namespace limitgauge::benchmarks
