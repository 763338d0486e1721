// Bytes that CELL and the finish model take, beside those of the structures that others keep
// refined meshes in, for the same vertices. As allocated; where the paper counts by a formula, that
// stands beside it.
#include <CGAL/Polyhedron_3.h>
#include <benchmark/benchmark.h>

#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "engine/surface/patch_model.h"
#include "tests/benchmark/counted_bytes.h"
#include "tests/benchmark/dome_finish.h"
#include "tests/benchmark/refined_meshes.h"

namespace limitgauge::benchmarks {
namespace {

using engine::surface::FloatPoint;
using engine::surface::LimitPatch;
using engine::surface::PatchModel;
using model::Vec3;
using FloatKernel = CGAL::Simple_cartesian<float>;
using Polyhedron = CGAL::Polyhedron_3<FloatKernel>;

constexpr int kMemoryDepth = 8;

/// The mesh built from its faces, reserved exactly: nothing that refining left behind.
SurfaceMesh rebuilt(const SurfaceMesh& source) {
  SurfaceMesh mesh;
  mesh.reserve(source.number_of_vertices(), source.number_of_edges(), source.number_of_faces());
  for (const auto v : source.vertices()) mesh.add_vertex(source.point(v));
  for (const auto f : source.faces())
    mesh.add_face(source.vertices_around_face(source.halfedge(f)));
  return mesh;
}

/// Builds a Polyhedron_3: points in single precision, a half-edge structure of pointers.
class PolyhedronBuilder : public CGAL::Modifier_base<Polyhedron::HalfedgeDS> {
 public:
  using Builder = CGAL::Polyhedron_incremental_builder_3<Polyhedron::HalfedgeDS>;
  explicit PolyhedronBuilder(std::function<void(Builder&)> fill) : fill_(std::move(fill)) {}
  void operator()(Polyhedron::HalfedgeDS& hds) override {
    Builder builder(hds);
    fill_(builder);
    builder.end_surface();
  }

 private:
  std::function<void(Builder&)> fill_;
};

std::unique_ptr<Polyhedron> polyhedron(std::function<void(PolyhedronBuilder::Builder&)> fill) {
  auto made = std::make_unique<Polyhedron>();
  PolyhedronBuilder builder(std::move(fill));
  made->delegate(builder);
  return made;
}

FloatKernel::Point_3 float_point(double x, double y, double z) {
  return {static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)};
}

std::unique_ptr<Polyhedron> polyhedron_of(const SurfaceMesh& mesh) {
  return polyhedron([&](PolyhedronBuilder::Builder& to) {
    to.begin_surface(mesh.number_of_vertices(), mesh.number_of_faces(), mesh.number_of_halfedges());
    for (const auto v : mesh.vertices())
      to.add_vertex(float_point(mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z()));
    for (const auto f : mesh.faces()) {
      to.begin_facet();
      for (const auto v : mesh.vertices_around_face(mesh.halfedge(f))) to.add_vertex_to_facet(v);
      to.end_facet();
    }
  });
}

/// The limit mesh of one patch, as a piece of its own: as the model has it too.
std::unique_ptr<Polyhedron> polyhedron_of(const LimitPatch& patch) {
  return polyhedron([&](PolyhedronBuilder::Builder& to) {
    const auto cells = static_cast<std::size_t>(patch.cells());
    to.begin_surface(patch.points.size(), cells * cells, 4 * cells * (cells + 1));
    for (const Vec3& p : patch.points) to.add_vertex(float_point(p.x, p.y, p.z));
    const auto at = [&](int u, int v) { return static_cast<std::size_t>(patch.index(u, v)); };
    for (int v = 0; v < patch.cells(); ++v)
      for (int u = 0; u < patch.cells(); ++u) {
        to.begin_facet();
        for (const std::size_t k : {at(u, v), at(u + 1, v), at(u + 1, v + 1), at(u, v + 1)})
          to.add_vertex_to_facet(k);
        to.end_facet();
      }
  });
}

/// Bytes of what `make` returns, as allocated.
template <class Make>
double bytes_of(const Make& make) {
  const std::size_t before = counted_bytes();
  const auto made = make();
  benchmark::DoNotOptimize(&made);
  return static_cast<double>(counted_bytes() - before);
}

/// The paper's structure: control points in single precision with the strips and rings that refine
/// them, no limit points, no normals.
void cell_memory(benchmark::State& state) {
  const SurfaceMesh mesh = cgal_refined(kMemoryDepth);
  // Both work in double precision, or round to single precision a few times: coordinates are
  // below 64 mm, so a rounding is below 4e-6 mm.
  if (largest_gap(points_of(cell_patches<Vec3>(kMemoryDepth)), points_of(mesh)) > 1e-9 ||
      largest_gap(points_of(cell_patches<FloatPoint>(kMemoryDepth)), points_of(mesh)) > 1e-4)
    return state.SkipWithError("the meshes differ");
  for (auto _ : state) {
    const double cell_float = bytes_of([] { return cell_patches<FloatPoint>(kMemoryDepth); });
    const double cell_double = bytes_of([] { return cell_patches<Vec3>(kMemoryDepth); });
    state.counters["vs_half_edge"] = cell_float / bytes_of([&] { return polyhedron_of(mesh); });
    const std::size_t float_bytes = sizeof(FloatPoint);
    state.counters["vs_half_edge_formula"] =
        static_cast<double>(engine::surface::cell_bytes_counted(kMemoryDepth, float_bytes)) /
        static_cast<double>(engine::surface::half_edge_bytes_counted(kMemoryDepth, float_bytes));
    const double tight = bytes_of([&] { return rebuilt(mesh); });
    state.counters["vs_surface_mesh"] = cell_double / tight;
    const auto vertices = static_cast<double>(mesh.number_of_vertices());
    state.counters["cell_bytes_a_vertex"] = cell_double / vertices;
    state.counters["tight_bytes_a_vertex"] = tight / vertices;
  }
}
BENCHMARK(cell_memory)->Unit(benchmark::kMillisecond)->Iterations(1);

/// What plans are made on: the aircraft's finish model with all that it holds, limit points and
/// normals in double precision, finer pieces at extraordinary corners, bounds and the cage. The
/// half-edge structure has the patches' meshes alone, points in single precision and no normals.
void model_memory(benchmark::State& state) {
  const auto make = [] {
    return std::make_unique<PatchModel>(
        aircraft_cage(), engine::surface::ModelRequest{0.01, kRadius_mm + 0.2 + 0.02, 10},
        model::RunControl{});
  };
  const auto model = make();
  const auto half_edges = [&] {
    std::vector<std::unique_ptr<Polyhedron>> all;
    for (const auto& patch : model->patches()) all.push_back(polyhedron_of(patch.limit));
    return all;
  };
  double vertices = 0;
  for (const auto& patch : model->patches())
    vertices += static_cast<double>(patch.limit.points.size());
  for (auto _ : state) {
    const double model_bytes = bytes_of(make);
    state.counters["vs_half_edge"] = model_bytes / bytes_of(half_edges);
    state.counters["bytes_a_vertex"] = model_bytes / vertices;
  }
  state.counters["vertices"] = vertices;
}
BENCHMARK(model_memory)->Unit(benchmark::kMillisecond)->Iterations(1);

}  // namespace
}  // namespace limitgauge::benchmarks
