#include <numeric>
#include <random>

#include "model/part/cage.h"
#include "tests/model/cage_builders.h"
#include "tests/support/catch.h"

using namespace limitgauge::model;
using namespace limitgauge::model::test;
using Kind = CageDefect::Kind;

TEST_CASE("good cages have no defects", "[unit][cage]") {
  CHECK(find_defects(Cage{}).empty());
  CHECK(find_defects(grid(3, 3)).empty());
  CHECK(find_defects(cube()).empty());
  // Two interior vertices of valence two: legal, if unusual.
  CHECK(find_defects(cage_of(4, {{0, 1, 2, 3}, {3, 2, 1, 0}})).empty());
}

TEST_CASE("an edge of three faces is found where the third meets it", "[unit][cage]") {
  const auto defects = find_defects(cage_of(5, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}));
  REQUIRE(defects.size() == 1);
  CHECK(defects[0].kind == Kind::non_manifold_edge);
  CHECK(defects[0].face == 2);
  CHECK(defects[0].vertices == std::vector<Index>{0, 1});
  CHECK(describe(defects[0]) == "face 3 is the third at the edge between vertices 1 and 2");
}

TEST_CASE("a face that turns the other way is found", "[unit][cage]") {
  const auto defects = find_defects(cage_of(4, {{0, 1, 2}, {0, 1, 3}}));
  REQUIRE(defects.size() == 1);
  CHECK(defects[0].kind == Kind::flipped_face);
  CHECK(defects[0].face == 1);
  CHECK(defects[0].vertices == std::vector<Index>{0, 1});
}

TEST_CASE("a vertex of two fans is found once", "[unit][cage]") {
  const auto open = find_defects(cage_of(7, {{0, 1, 2}, {0, 3, 4}, {0, 5, 6}}));
  REQUIRE(open.size() == 1);
  CHECK(open[0].kind == Kind::non_manifold_vertex);
  CHECK(open[0].face == 1);
  CHECK(open[0].vertices == std::vector<Index>{0});
}

TEST_CASE("a closed fan and an open one at a vertex are two fans", "[unit][cage]") {
  // Counting faces and edges alone would take this for one open fan.
  const auto defects = find_defects(cage_of(6, {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {0, 4, 5}}));
  REQUIRE(defects.size() == 1);
  CHECK(defects[0].kind == Kind::non_manifold_vertex);
  CHECK(defects[0].face == 3);
}

TEST_CASE("degenerate faces are found", "[unit][cage]") {
  CHECK(find_defects(cage_of(4, {{0, 1}})).at(0).kind == Kind::degenerate_face);
  CHECK(find_defects(cage_of(4, {{0, 1, 2, 1}})).at(0).vertices == std::vector<Index>{1});
  CHECK(find_defects(cage_of(4, {{0, 1, 2}, {1, 2, 4}})).at(0).face == 1);
  CHECK(find_defects(cage_of(4, {{0, 1, -1}})).at(0).vertices == std::vector<Index>{-1});
  CHECK(find_defects(cage_of(4, {{}})).at(0).kind == Kind::degenerate_face);
}

TEST_CASE("one flipped quad of a grid is always found, with its edges", "[property][cage]") {
  std::mt19937 random(3);
  for (int round = 0; round < 40; ++round) {
    const Cage good = grid(4, 4);
    const Index flipped = static_cast<Index>(random() % 16);
    Cage cage = good;
    std::reverse(cage.face_corners.begin() + 4 * flipped,
                 cage.face_corners.begin() + 4 * flipped + 4);
    const auto defects = find_defects(cage);
    const Index column = flipped % 4, row = flipped / 4;
    const std::size_t neighbours = (column > 0) + (column < 3) + (row > 0) + (row < 3);
    CHECK(defects.size() == neighbours);
    for (const CageDefect& defect : defects) CHECK(defect.kind == Kind::flipped_face);
    CHECK(std::is_sorted(defects.begin(), defects.end(),
                         [](const auto& a, const auto& b) { return a.face < b.face; }));
  }
}

TEST_CASE("defects do not depend on how the vertices are numbered", "[property][cage]") {
  std::mt19937 random(11);
  for (int round = 0; round < 40; ++round) {
    Cage cage = grid(3, 3);
    std::vector<Index> order(cage.vertices.size());
    std::iota(order.begin(), order.end(), 0);
    std::shuffle(order.begin(), order.end(), random);
    for (Index& v : cage.face_corners) v = order[v];
    CHECK(find_defects(cage).empty());
  }
}
