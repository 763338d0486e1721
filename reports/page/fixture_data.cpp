#include "reports/page/fixture_data.h"

#include <algorithm>

#include "reports/page/mesh_reduction.h"
#include "reports/page/surface_data.h"
#include "reports/text/text.h"

namespace limitgauge::reports::page {

std::size_t Fixtures::add(const model::Fixture& fixture, const model::Pose& to_part, Blob& blob) {
  const auto same = std::ranges::find_if(placed_, [&](const Placed& placed) {
    return placed.mesh == fixture.mesh && placed.to_part == to_part;
  });
  if (same != placed_.end()) return same->index;
  const std::size_t triangles = fixture.mesh->triangles.size();
  const model::TriangleMesh shown =
      turned(triangles > kMostFixtureTriangles ? reduced(*fixture.mesh, kMostFixtureTriangles)
                                               : *fixture.mesh,
             to_part);
  const std::size_t index = add_shown(clean_text(fixture.name), shown, triangles, blob);
  placed_.push_back({fixture.mesh, to_part, index});
  return index;
}

std::size_t Fixtures::add_shown(const std::string& name, const model::TriangleMesh& shown,
                                std::size_t file_triangles, Blob& blob) {
  const GridPoints points = on_grid(shown.vertices);
  Known one{name, points.multiples, corners_of(shown.triangles)};
  const auto known = std::ranges::find(known_, one);
  if (known != known_.end()) return static_cast<std::size_t>(known - known_.begin());
  json_.push_back({{"name", name},
                   {"position", points_block(points, blob)},
                   {"triangle", blob.add(one.corners, 3)},
                   {"file_triangles", file_triangles}});
  known_.push_back(std::move(one));
  return known_.size() - 1;
}

}  // namespace limitgauge::reports::page
