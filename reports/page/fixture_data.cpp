#include "reports/page/fixture_data.h"

#include <algorithm>

#include "reports/page/mesh_reduction.h"
#include "reports/page/surface_data.h"
#include "reports/text/text.h"

namespace limitgauge::reports::page {

std::size_t Fixtures::add(const model::Fixture& fixture, const model::Pose& to_part, Blob& blob) {
  const std::size_t triangles = fixture.mesh->triangles.size();
  const model::TriangleMesh shown =
      turned(triangles > kMostFixtureTriangles ? reduced(*fixture.mesh, kMostFixtureTriangles)
                                               : *fixture.mesh,
             to_part);
  const GridPoints points = on_grid(shown.vertices);
  Known one{clean_text(fixture.name), points.multiples, corners_of(shown.triangles)};
  const auto known = std::ranges::find(known_, one);
  if (known != known_.end()) return static_cast<std::size_t>(known - known_.begin());
  json_.push_back({{"name", one.name},
                   {"position", points_block(points, blob)},
                   {"triangle", blob.add(one.corners, 3)},
                   {"file_triangles", triangles}});
  known_.push_back(std::move(one));
  return known_.size() - 1;
}

}  // namespace limitgauge::reports::page
