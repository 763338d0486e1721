#include "tests/benchmark/refined_meshes.h"

#include <CGAL/subdivision_method_3.h>
#include <opensubdiv/far/primvarRefiner.h>
#include <opensubdiv/far/topologyDescriptor.h>
#include <opensubdiv/far/topologyRefinerFactory.h>

#include <algorithm>
#include <memory>

#include "model/part/cage_obj.h"
#include "tests/support/folders.h"

namespace limitgauge::benchmarks {
namespace Far = OpenSubdiv::Far;
using engine::surface::BasicCellPatch;
using engine::surface::FloatPoint;
using engine::surface::OuterMesh;
using model::Index;
using model::Vec3;

const model::Cage& aircraft_cage() {
  static const model::Cage cage =
      model::read_cage_obj(tests::fixtures() / "cages" / "aircraft.obj");
  return cage;
}

template <class Point>
std::vector<BasicCellPatch<Point>> cell_patches(int depth) {
  const OuterMesh mesh = engine::surface::make_outer_mesh(aircraft_cage());
  std::vector<BasicCellPatch<Point>> patches;
  patches.reserve(static_cast<std::size_t>(mesh.face_count()));
  for (Index f = 0; f < mesh.face_count(); ++f) {
    patches.emplace_back(mesh, f);
    while (patches.back().depth() < depth) patches.back().refine();
  }
  return patches;
}
template std::vector<BasicCellPatch<Vec3>> cell_patches(int depth);
template std::vector<BasicCellPatch<FloatPoint>> cell_patches(int depth);

namespace {

SurfaceMesh cgal_cage() {
  SurfaceMesh mesh;
  for (const Vec3& p : aircraft_cage().vertices) mesh.add_vertex({p.x, p.y, p.z});
  for (Index f = 0; f < aircraft_cage().face_count(); ++f) {
    std::vector<SurfaceMesh::Vertex_index> corners;
    for (const Index v : aircraft_cage().face(f))
      corners.emplace_back(static_cast<std::uint32_t>(v));
    mesh.add_face(corners);
  }
  return mesh;
}

}  // namespace

SurfaceMesh cgal_refined(int depth) {
  SurfaceMesh mesh = cgal_cage();
  CGAL::Subdivision_method_3::CatmullClark_subdivision(
      mesh, CGAL::parameters::number_of_iterations(depth));
  return mesh;
}

std::vector<FarPoint> far_refined(int depth) {
  const model::Cage& cage = aircraft_cage();
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

std::vector<Vec3> points_of(const SurfaceMesh& mesh) {
  std::vector<Vec3> points;
  for (const auto v : mesh.vertices())
    points.push_back({mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z()});
  return points;
}

}  // namespace limitgauge::benchmarks
