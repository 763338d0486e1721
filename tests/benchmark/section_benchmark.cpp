// The finish stage's 872 drive planes through the aircraft's finish model against CGAL's slicer
// with an AABB tree on the same triangles. Both from what they need to be built once: our
// quadtrees, its tree of edges; both on one thread. Both join curves across patches. The points
// that they find are held against each other, plane by plane.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_slicer.h>
#include <CGAL/Surface_mesh.h>
#include <benchmark/benchmark.h>

#include <algorithm>
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

using Points = std::vector<Vec3>;

/// Points at places of their own, in order: of those that lie within `apart_mm` of another the
/// first. CGAL gives a point twice where the side of a patch that is finer than its neighbour's is
/// open in its mesh.
Points places_of(Points points, double apart_mm) {
  std::sort(points.begin(), points.end(),
            [](const Vec3& a, const Vec3& b) { return std::tie(a.y, a.z) < std::tie(b.y, b.z); });
  Points out;
  for (const Vec3& p : points) {
    bool known = false;
    for (auto q = out.rbegin(); q != out.rend() && p.y - q->y <= apart_mm && !known; ++q)
      known = distance(*q, p) <= apart_mm;
    if (!known) out.push_back(p);
  }
  return out;
}

/// Points of `of` without one of `among` within `apart_mm`. Both in order.
std::size_t missing(const Points& of, const Points& among, double apart_mm) {
  std::size_t count = 0;
  for (const Vec3& p : of) {
    auto q = std::lower_bound(among.begin(), among.end(), p.y - apart_mm,
                              [](const Vec3& a, double y) { return a.y < y; });
    bool found = false;
    for (; q != among.end() && q->y <= p.y + apart_mm && !found; ++q)
      found = distance(*q, p) <= apart_mm;
    count += !found;
  }
  return count;
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

std::vector<Polylines> cgal_sections(const CGAL::Polygon_mesh_slicer<Mesh, Kernel>& slicer,
                                     const std::vector<double>& values) {
  std::vector<Polylines> all(values.size());
  for (std::size_t k = 0; k < values.size(); ++k)
    slicer(Kernel::Plane_3(1, 0, 0, -values[k]), std::back_inserter(all[k]));
  return all;
}

/// What one of the two found and the other did not, over all planes.
struct Comparison {
  std::size_t ours = 0, theirs = 0;            ///< places
  std::size_t only_ours = 0, only_theirs = 0;  ///< of them
};

Comparison compare(const Aircraft& aircraft, const std::vector<double>& values,
                   const std::vector<Polylines>& theirs) {
  constexpr double kSame_mm = 1e-9;
  const auto curves = engine::surface::sections(aircraft.model, aircraft.mesh, 0, values, {});
  Comparison c;
  for (std::size_t k = 0; k < values.size(); ++k) {
    Points a, b;
    for (const auto& curve : curves[k]) a.insert(a.end(), curve.points.begin(), curve.points.end());
    for (const auto& line : theirs[k])
      for (const auto& p : line) b.push_back({p.x(), p.y(), p.z()});
    a = places_of(std::move(a), kSame_mm), b = places_of(std::move(b), kSame_mm);
    c.ours += a.size(), c.theirs += b.size();
    c.only_ours += missing(a, b, kSame_mm), c.only_theirs += missing(b, a, kSame_mm);
  }
  return c;
}

void section_cgal_slicer(benchmark::State& state) {
  const Aircraft aircraft;
  const auto values = aircraft.planes();
  const Mesh mesh = welded(aircraft.mesh.grids);
  const CGAL::Polygon_mesh_slicer<Mesh, Kernel> slicer(mesh);
  Polylines warm;
  slicer(Kernel::Plane_3(1, 0, 0, 0), std::back_inserter(warm));  // builds its tree
  std::vector<Polylines> found;
  for (auto _ : state) found = cgal_sections(slicer, values);
  const Comparison c = compare(aircraft, values, found);
  if (c.only_ours + c.only_theirs > 0 || c.ours != c.theirs)
    state.SkipWithError("the two do not find the same points");
  state.counters["points"] = static_cast<double>(c.theirs);
  state.counters["only_ours"] = static_cast<double>(c.only_ours);
  state.counters["only_theirs"] = static_cast<double>(c.only_theirs);
  state.counters["faces"] = static_cast<double>(mesh.number_of_faces());
}

BENCHMARK(section_family)->Unit(benchmark::kMillisecond);
BENCHMARK(section_family_and_trees)->Unit(benchmark::kMillisecond);
BENCHMARK(section_cgal_slicer)->Unit(benchmark::kMillisecond)->Iterations(1);

}  // namespace
}  // namespace limitgauge::benchmarks
