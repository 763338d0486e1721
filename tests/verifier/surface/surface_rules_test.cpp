#include "verifier/surface/surface_rules.h"

#include "tests/support/cages.h"
#include "tests/support/catch.h"

namespace limitgauge::verifier {

using namespace tests;

TEST_CASE("the rules of a cage count what shapes its surface", "[unit]") {
  model::Cage cage = grid_cage(
      4, 4,
      [](int i, int j) {
        return model::Vec3{double(i), double(j), 0};
      },
      model::BoundaryRule::edge_and_corner);
  // From the boundary to the middle: a dart there. Vertex (i, j) is 5·j + i.
  cage.creases = {{{10, 11}, 10}, {{11, 12}, 12}, {{7, 8}, 1.5}, {{16, 17}, 0}};
  cage.corners = {{18, 10}, {6, 2.5}};
  cage.holes = {3};
  const SurfaceRules rules = rules_of(cage);
  CHECK(rules.boundary == model::BoundaryRule::edge_and_corner);
  CHECK(rules.sharp_edges == 2);
  CHECK(rules.semi_sharp_edges == 1);
  CHECK(rules.sharp_vertices == 1);
  CHECK(rules.semi_sharp_vertices == 1);
  CHECK(rules.darts == 1);
  CHECK(rules.holes == 1);
  CHECK(rules.infinite_sharpness == 10);
  cage.corners.push_back({12, 10});  // the dart's end made a sharp corner
  CHECK(rules_of(cage).darts == 0);
  CHECK(rules_of(cube_cage()).sharp_edges == 0);
}

}  // namespace limitgauge::verifier
