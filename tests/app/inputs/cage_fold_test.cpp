#include "app/inputs/cage_fold.h"

#include <array>

#include "tests/support/cages.h"
#include "tests/support/catch.h"

namespace limitgauge::app {
namespace {

using model::Index;

TEST_CASE("a cage that lies back on itself is told by its faces", "[unit]") {
  model::Cage plate;
  plate.vertices = {{0, 0, 0}, {9, 0, 0}, {9, 9, 0}, {0, 9, 0}};
  plate.add_face(std::array<Index, 4>{0, 1, 2, 3});
  CHECK(!folded_faces(plate));
  model::Cage pillow = plate;
  pillow.add_face(std::array<Index, 4>{2, 1, 0, 3});
  CHECK(folded_faces(pillow) == std::pair<Index, Index>{0, 1});
  pillow.holes = {1};
  CHECK(!folded_faces(pillow));
  // Over an edge, with vertices of its own that come back to the first ones.
  model::Cage flap = plate;
  flap.vertices.push_back({9, 1e-9, 0});
  flap.vertices.push_back({0, 0, 0});
  flap.add_face(std::array<Index, 4>{3, 2, 4, 5});
  CHECK(folded_faces(flap) == std::pair<Index, Index>{0, 1});
  flap.vertices[4].z = flap.vertices[5].z = 1;
  CHECK(!folded_faces(flap));
}

TEST_CASE("ordinary cages lie nowhere on themselves", "[unit]") {
  CHECK(!folded_faces(tests::cube_cage()));
  CHECK(!folded_faces(tests::star_cage(7, 1)));
  CHECK(!folded_faces(tests::plane_cage(10, 0.1, 0)));
}

}  // namespace
}  // namespace limitgauge::app
