// CELL beside the structures that others keep refined meshes in: bytes for the same mesh, time to
// refine the aircraft's cage. One thread each. The meshes are checked to hold the same points.
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/subdivision_method_3.h>
#include <benchmark/benchmark.h>
#include <opensubdiv/far/primvarRefiner.h>
#include <opensubdiv/far/topologyDescriptor.h>
#include <opensubdiv/far/topologyRefinerFactory.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <vector>

#include "engine/surface/cell/cell_patch.h"
#include "model/part/cage_obj.h"
#include "tests/benchmark/counted_bytes.h"
#include "tests/support/folders.h"

namespace limitgauge::benchmarks {
namespace {

using engine::surface::BasicCellPatch;
using engine::surface::FloatPoint;
using engine::surface::OuterMesh;
using model::Index;
using model::Vec3;
using DoubleKernel = CGAL::Simple_cartesian<double>;
using FloatKernel = CGAL::Simple_cartesian<float>;
using SurfaceMesh = CGAL::Surface_mesh<DoubleKernel::Point_3>;
using Polyhedron = CGAL::Polyhedron_3<FloatKernel>;
namespace Far = OpenSubdiv::Far;

constexpr int kMemoryDepth = 8;
constexpr int kTimeDepth = 7;

const model::Cage& aircraft() {
  static const model::Cage cage =
      model::read_cage_obj(tests::fixtures() / "cages" / "aircraft.obj");
  return cage;
}

const OuterMesh& aircraft_mesh() {
  static const OuterMesh mesh = engine::surface::make_outer_mesh(aircraft());
  return mesh;
}

template <class Point>
std::vector<BasicCellPatch<Point>> cell_patches(int depth) {
  const OuterMesh& mesh = aircraft_mesh();
  std::vector<BasicCellPatch<Point>> patches;
  patches.reserve(static_cast<std::size_t>(mesh.face_count()));
  for (Index f = 0; f < mesh.face_count(); ++f) {
    patches.emplace_back(mesh, f);
    while (patches.back().depth() < depth) patches.back().refine();
  }
  return patches;
}

SurfaceMesh cgal_cage() {
  SurfaceMesh mesh;
  for (const Vec3& p : aircraft().vertices) mesh.add_vertex({p.x, p.y, p.z});
  for (Index f = 0; f < aircraft().face_count(); ++f) {
    std::vector<SurfaceMesh::Vertex_index> corners;
    for (const Index v : aircraft().face(f)) corners.emplace_back(static_cast<std::uint32_t>(v));
    mesh.add_face(corners);
  }
  return mesh;
}

SurfaceMesh cgal_refined(int depth) {
  SurfaceMesh mesh = cgal_cage();
  CGAL::Subdivision_method_3::CatmullClark_subdivision(
      mesh, CGAL::parameters::number_of_iterations(depth));
  return mesh;
}

/// Single precision, as OpenSubdiv's own examples keep points.
struct FarPoint {
  float x = 0, y = 0, z = 0;
  void Clear() { x = y = z = 0; }
  void AddWithWeight(const FarPoint& other, float weight) {
    x += other.x * weight, y += other.y * weight, z += other.z * weight;
  }
};

std::vector<FarPoint> far_refined(int depth) {
  const model::Cage& cage = aircraft();
  std::vector<int> sizes;
  for (Index f = 0; f < cage.face_count(); ++f)
    sizes.push_back(static_cast<int>(cage.face(f).size()));
  Far::TopologyDescriptor d;
  d.numVertices = static_cast<int>(cage.vertices.size());
  d.numFaces = cage.face_count();
  d.numVertsPerFace = sizes.data();
  d.vertIndicesPerFace = cage.face_corners.data();
  OpenSubdiv::Sdc::Options options;
  options.SetVtxBoundaryInterpolation(OpenSubdiv::Sdc::Options::VTX_BOUNDARY_EDGE_ONLY);
  using Factory = Far::TopologyRefinerFactory<Far::TopologyDescriptor>;
  const std::unique_ptr<Far::TopologyRefiner> refiner(
      Factory::Create(d, Factory::Options(OpenSubdiv::Sdc::SCHEME_CATMARK, options)));
  refiner->RefineUniform(Far::TopologyRefiner::UniformOptions(depth));
  std::vector<FarPoint> at;
  for (const Vec3& p : cage.vertices)
    at.push_back({static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)});
  for (int level = 1; level <= depth; ++level) {
    std::vector<FarPoint> next(static_cast<std::size_t>(refiner->GetLevel(level).GetNumVertices()));
    FarPoint* to = next.data();
    Far::PrimvarRefiner(*refiner).Interpolate(level, at.data(), to);
    at = std::move(next);
  }
  return at;
}

/// Largest distance of a point of `from` from the nearest point of `to` along a sorted axis: the
/// meshes are sampled, so that the search stays short.
double largest_gap(const std::vector<Vec3>& from, std::vector<Vec3> to) {
  constexpr double kWindow = 1e-3;
  std::sort(to.begin(), to.end(), [](const Vec3& a, const Vec3& b) { return a.x < b.x; });
  double gap = 0;
  for (std::size_t i = 0; i < from.size(); i += 101) {
    const Vec3 low{from[i].x - kWindow, 0, 0};
    auto at = std::lower_bound(to.begin(), to.end(), low,
                               [](const Vec3& a, const Vec3& b) { return a.x < b.x; });
    double nearest = kWindow;
    for (; at != to.end() && at->x <= from[i].x + kWindow; ++at)
      nearest = std::min(nearest, distance(*at, from[i]));
    gap = std::max(gap, nearest);
  }
  return gap;
}

template <class Point>
std::vector<Vec3> points_of(const std::vector<BasicCellPatch<Point>>& patches) {
  std::vector<Vec3> points;
  for (const auto& patch : patches)
    for (int v = 0; v <= patch.cells(); ++v)
      for (int u = 0; u <= patch.cells(); ++u) points.push_back(patch.control(u, v));
  return points;
}

std::vector<Vec3> points_of(const SurfaceMesh& mesh) {
  std::vector<Vec3> points;
  for (const auto v : mesh.vertices())
    points.push_back({mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z()});
  return points;
}

/// The mesh built from its faces, reserved exactly: nothing that refining left behind.
SurfaceMesh rebuilt(const SurfaceMesh& source) {
  SurfaceMesh mesh;
  mesh.reserve(source.number_of_vertices(), source.number_of_edges(), source.number_of_faces());
  for (const auto v : source.vertices()) mesh.add_vertex(source.point(v));
  for (const auto f : source.faces())
    mesh.add_face(source.vertices_around_face(source.halfedge(f)));
  return mesh;
}

/// Builds a Polyhedron_3 of the points and faces of a mesh.
class PolyhedronBuilder : public CGAL::Modifier_base<Polyhedron::HalfedgeDS> {
 public:
  explicit PolyhedronBuilder(const SurfaceMesh& source) : source_(source) {}
  void operator()(Polyhedron::HalfedgeDS& hds) override {
    CGAL::Polyhedron_incremental_builder_3<Polyhedron::HalfedgeDS> builder(hds);
    builder.begin_surface(source_.number_of_vertices(), source_.number_of_faces(),
                          source_.number_of_halfedges());
    for (const auto v : source_.vertices()) {
      const auto& p = source_.point(v);
      builder.add_vertex(
          {static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z())});
    }
    for (const auto f : source_.faces()) {
      builder.begin_facet();
      for (const auto v : source_.vertices_around_face(source_.halfedge(f)))
        builder.add_vertex_to_facet(v);
      builder.end_facet();
    }
    builder.end_surface();
  }

 private:
  const SurfaceMesh& source_;
};

/// Bytes of what `make` returns, as allocated.
template <class Make>
double bytes_of(const Make& make) {
  const std::size_t before = counted_bytes();
  const auto made = make();
  benchmark::DoNotOptimize(&made);
  return static_cast<double>(counted_bytes() - before);
}

std::unique_ptr<Polyhedron> polyhedron_of(const SurfaceMesh& mesh) {
  auto polyhedron = std::make_unique<Polyhedron>();
  PolyhedronBuilder builder(mesh);
  polyhedron->delegate(builder);
  return polyhedron;
}

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
    // As CGAL's own refinement leaves the mesh, which is how a user comes by it: the room reserved
    // for the last step stays. The second figure is that of a copy without a byte to spare.
    state.counters["vs_surface_mesh"] =
        cell_double / bytes_of([] { return cgal_refined(kMemoryDepth); });
    const double tight = bytes_of([&] { return rebuilt(mesh); });
    state.counters["vs_surface_mesh_tight"] = cell_double / tight;
    state.counters["cell_bytes_a_vertex"] = cell_double / mesh.number_of_vertices();
    state.counters["tight_bytes_a_vertex"] = tight / mesh.number_of_vertices();
  }
}
BENCHMARK(cell_memory)->Unit(benchmark::kMillisecond)->Iterations(1);

template <class Point>
void cell_refine(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(cell_patches<Point>(kTimeDepth));
}
BENCHMARK(cell_refine<Vec3>)->Name("cell_refine")->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(cell_refine<FloatPoint>)
    ->Name("cell_refine_float")
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

void cell_refine_cgal(benchmark::State& state) {
  if (largest_gap(points_of(cell_patches<Vec3>(kTimeDepth)), points_of(cgal_refined(kTimeDepth))) >
      1e-9)
    return state.SkipWithError("the meshes differ");
  for (auto _ : state) benchmark::DoNotOptimize(cgal_refined(kTimeDepth));
}
BENCHMARK(cell_refine_cgal)->Unit(benchmark::kMillisecond)->UseRealTime();

void cell_refine_opensubdiv(benchmark::State& state) {
  std::vector<Vec3> points;
  for (const FarPoint& p : far_refined(kTimeDepth)) points.push_back({p.x, p.y, p.z});
  if (largest_gap(points_of(cell_patches<FloatPoint>(kTimeDepth)), points) > 1e-4)
    return state.SkipWithError("the meshes differ");
  for (auto _ : state) benchmark::DoNotOptimize(far_refined(kTimeDepth));
}
BENCHMARK(cell_refine_opensubdiv)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace limitgauge::benchmarks
