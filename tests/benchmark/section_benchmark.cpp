// The finish stage's 872 drive planes through the aircraft's finish model against CGAL's slicer
// with an AABB tree on the same triangles. Both from what they need to be built once: our
// quadtrees, its tree of edges; both on one thread.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_slicer.h>
#include <CGAL/Surface_mesh.h>
#include <benchmark/benchmark.h>

#include <iterator>
#include <map>
#include <tuple>
#include <vector>

#include "engine/surface/section/sections.h"
#include "model/part/cage_obj.h"
#include "tests/support/folders.h"

namespace limitgauge::benchmarks {
namespace {

using engine::surface::Grid;
using model::Vec3;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Polylines = std::vector<std::vector<Kernel::Point_3>>;

/// The paper's finish stage: 872 planes 0.1 mm apart over the part and the ball at both ends.
constexpr int kPlanes = 872;
constexpr double kStep = 0.1, kPrecision = 0.01, kMeshError = 0.0025;

struct Aircraft {
  engine::surface::PatchModel model{
      model::read_cage_obj(tests::fixtures() / "cages/aircraft.obj"), {kPrecision, 3, 10}, {}};
  engine::surface::OffsetModel mesh = engine::surface::sample_offset(model, 0, kMeshError);

  std::vector<double> planes() const {
    const double middle = model.bounding_box().centre().x;
    std::vector<double> values;
    for (int k = 0; k < kPlanes; ++k) values.push_back(middle + (k - (kPlanes - 1) / 2.0) * kStep);
    return values;
  }
};

/// All triangles, welded where patches share points.
Mesh welded(const std::vector<Grid>& grids) {
  Mesh mesh;
  std::map<std::tuple<double, double, double>, Mesh::Vertex_index> known;
  const auto vertex = [&](const Vec3& p) {
    const auto [place, fresh] = known.try_emplace({p.x, p.y, p.z});
    if (fresh) place->second = mesh.add_vertex({p.x, p.y, p.z});
    return place->second;
  };
  for (const Grid& grid : grids)
    for (int v = 0; v + 1 < grid.rows; ++v)
      for (int u = 0; u + 1 < grid.columns; ++u) {
        const auto a = vertex(grid.at(u, v)), b = vertex(grid.at(u + 1, v));
        const auto c = vertex(grid.at(u + 1, v + 1)), d = vertex(grid.at(u, v + 1));
        mesh.add_face(a, b, c);
        mesh.add_face(a, c, d);
      }
  return mesh;
}

void section_family(benchmark::State& state) {
  const Aircraft aircraft;
  const auto values = aircraft.planes();
  const auto trees = engine::surface::section_trees(aircraft.mesh, 0, {});
  std::size_t points = 0;
  for (auto _ : state) {
    const auto curves = engine::surface::sections(aircraft.model, aircraft.mesh, trees, values, {});
    points = 0;
    for (const auto& plane : curves)
      for (const auto& curve : plane) points += curve.points.size();
  }
  state.counters["points"] = static_cast<double>(points);
}

/// With the quadtrees built anew each time.
void section_family_and_trees(benchmark::State& state) {
  const Aircraft aircraft;
  const auto values = aircraft.planes();
  for (auto _ : state)
    benchmark::DoNotOptimize(
        engine::surface::sections(aircraft.model, aircraft.mesh, 0, values, {}));
}

void section_cgal_slicer(benchmark::State& state) {
  const Aircraft aircraft;
  const auto values = aircraft.planes();
  const Mesh mesh = welded(aircraft.mesh.grids);
  const CGAL::Polygon_mesh_slicer<Mesh, Kernel> slicer(mesh);
  Polylines warm;
  slicer(Kernel::Plane_3(1, 0, 0, 0), std::back_inserter(warm));  // builds its tree
  std::size_t points = 0;
  for (auto _ : state) {
    points = 0;
    for (const double value : values) {
      Polylines lines;
      slicer(Kernel::Plane_3(1, 0, 0, -value), std::back_inserter(lines));
      for (const auto& line : lines) points += line.size();
    }
  }
  state.counters["points"] = static_cast<double>(points);
  state.counters["faces"] = static_cast<double>(mesh.number_of_faces());
}

BENCHMARK(section_family)->Unit(benchmark::kMillisecond);
BENCHMARK(section_family_and_trees)->Unit(benchmark::kMillisecond);
BENCHMARK(section_cgal_slicer)->Unit(benchmark::kMillisecond)->Iterations(1);

}  // namespace
}  // namespace limitgauge::benchmarks
