#include "verifier/ridge_cells.h"

#include "tests/support/cages.h"
#include "tests/support/catch.h"
#include "verifier/reference_surface.h"

namespace limitgauge::verifier {

using namespace tests;
using model::Vec3;

TEST_CASE("normals of a sharp edge stay those of its faces down to an irregular vertex",
          "[property]") {
  // A crease that turns in the middle of a bent sheet: one face on its one side there, three on the
  // other.
  const int n = 4;
  model::Cage cage = grid_cage(
      n, n,
      [](int i, int j) {
        return Vec3{1.0 * i, 1.0 * j, 0.4 * std::sin(1.3 * i + 0.4) * std::cos(0.9 * j)};
      },
      model::BoundaryRule::edge_and_corner);
  const auto vertex = [&](int i, int j) { return model::Index(j * (n + 1) + i); };
  for (int k = 0; k < n / 2; ++k) {
    cage.creases.push_back({{vertex(k, 2), vertex(k + 1, 2)}, 10});
    cage.creases.push_back({{vertex(2, k), vertex(2, k + 1)}, 10});
  }
  const ReferenceSurface surface(cage);
  const std::vector<RidgeCell> ridges = ridge_cells(surface.tree(), 0.3);
  const Vec3 end = surface.evaluate(5, 1, 1).position;
  std::size_t near = 0;
  for (const RidgeCell& ridge : ridges) {
    REQUIRE(ridge.count == 2);
    const OffsetCell cell = ridge.offset();
    const double from_end = distance(cell.middle, end);
    near += from_end < 1e-6;
    CAPTURE(from_end);
    // The faces meet at less than half a right angle along all of the crease.
    CHECK(cell.spread_rad < 0.8);
    CHECK(cell.normal.z > 0.5);
  }
  CHECK(near > 3);
}

}  // namespace limitgauge::verifier
