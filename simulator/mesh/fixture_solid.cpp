#include "simulator/mesh/fixture_solid.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "simulator/sweep/depth_bound.h"

namespace limitgauge::simulator {
namespace {

using model::Box3;
using model::TriangleMesh;
using model::Vec3;

void require_known_vertices(const TriangleMesh& mesh) {
  for (const auto& triangle : mesh.triangles)
    for (const std::uint32_t v : triangle)
      if (v >= mesh.vertices.size())
        throw std::invalid_argument("a fixture's triangle has a vertex that does not exist");
  if (!std::all_of(mesh.vertices.begin(), mesh.vertices.end(),
                   [](const Vec3& v) { return is_finite(v); }))
    throw std::invalid_argument("a fixture with a coordinate that is not finite");
}

// Closed: every edge is gone along as often one way as the other.
void require_closed(const TriangleMesh& mesh) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> forth, back;
  for (const auto& t : mesh.triangles)
    for (int i = 0; i < 3; ++i) {
      const std::uint32_t a = t[i], b = t[(i + 1) % 3];
      if (a < b) forth.emplace_back(a, b);
      if (b < a) back.emplace_back(b, a);
    }
  std::sort(forth.begin(), forth.end());
  std::sort(back.begin(), back.end());
  if (forth != back) throw std::invalid_argument("a fixture's mesh is not closed");
}

const TriangleMesh& checked(const std::shared_ptr<const TriangleMesh>& mesh) {
  if (!mesh || mesh->triangles.empty()) throw std::invalid_argument("a fixture without triangles");
  require_known_vertices(*mesh);
  require_closed(*mesh);
  return *mesh;
}

// The swept distance is convex: over a box it is nowhere below its tangent at the middle.
double lower_bound(const CutterProfile& body, const SweptMove& move, const Box3& box) {
  const SweptSample s = swept_distance(body, move, box.centre());
  return s.distance - support(box.size() * 0.5, s.gradient);
}

}  // namespace

FixtureSolid::FixtureSolid(std::shared_ptr<const TriangleMesh> mesh) : tree_(checked(mesh)) {}

std::optional<SurfacePlace> FixtureSolid::nearest(const CutterProfile& body, const SweptMove& move,
                                                  double bound, double precision_mm) const {
  std::optional<SurfacePlace> best;
  const auto least_in = [&](const Box3& box) { return lower_bound(body, move, box); };
  const auto look = [&](std::uint32_t number) {
    const auto place = least_on_triangle(body, move, tree_.triangle(number), bound, precision_mm);
    if (place) best = place, bound = place->distance;
    return bound;
  };
  tree_.search(bound, least_in, look);
  return best;
}

bool FixtureSolid::encloses(const Vec3& p) const {
  return tree_.winding(p) != 0;
}

}  // namespace limitgauge::simulator
