#include "simulator/mesh/fixture_solid.h"

#include <stdexcept>

#include "model/mesh/mesh_defect.h"
#include "simulator/sweep/depth_bound.h"

namespace limitgauge::simulator {
namespace {

using model::Box3;
using model::TriangleMesh;
using model::Vec3;

const TriangleMesh& checked(const std::shared_ptr<const TriangleMesh>& mesh) {
  if (!mesh) throw std::invalid_argument("a fixture without its mesh");
  if (const auto defect = find_defect(*mesh))
    throw std::invalid_argument("a fixture's mesh bounds no solid: " + defect->wrong);
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
