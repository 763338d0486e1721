#include "model/part/cage.h"

#include <random>

#include "tests/model/cage_builders.h"
#include "tests/support/catch.h"

using namespace limitgauge::model;
using namespace limitgauge::model::test;
using Rows = std::vector<std::array<Index, 2>>;

TEST_CASE("summary of a grid: one rectangle of quads", "[unit][cage]") {
  const CageSummary summary = summarize(grid(4, 3));
  CHECK(summary.vertices == 20);
  CHECK(summary.faces == 12);
  CHECK(summary.patches == 12);
  CHECK(summary.boundary_edges == 14);
  CHECK(summary.extraordinary_vertices == 0);
  CHECK(summary.face_sizes == Rows{{4, 12}});
  CHECK(summary.interior_valences == Rows{{4, 6}});
  CHECK(summary.boundary_valences == Rows{{2, 4}, {3, 10}});
}

TEST_CASE("summary of a cube: closed, every vertex extraordinary", "[unit][cage]") {
  const CageSummary summary = summarize(cube());
  CHECK(summary.boundary_edges == 0);
  CHECK(summary.extraordinary_vertices == 8);
  CHECK(summary.interior_valences == Rows{{3, 8}});
  CHECK(summary.boundary_valences.empty());
}

TEST_CASE("summary: an n-gon is n patches, a boundary vertex of three faces is extraordinary",
          "[unit][cage]") {
  // Three triangles and a quad around vertex 0, which stays on the boundary.
  const Cage cage = cage_of(7, {{0, 1, 2}, {0, 2, 3}, {0, 3, 4, 5}});
  const CageSummary summary = summarize(cage);
  CHECK(summary.patches == 3 + 3 + 1);
  CHECK(summary.extraordinary_vertices == 1);
  CHECK(summary.vertices == 6);  // the seventh belongs to no face
  CHECK(summary.face_sizes == Rows{{3, 2}, {4, 1}});
}

TEST_CASE("summary of nothing", "[unit][cage]") {
  const CageSummary summary = summarize(Cage{});
  CHECK(summary.vertices == 0);
  CHECK(summary.patches == 0);
  CHECK(summary.face_sizes.empty());
}

TEST_CASE("a rotation by quarter turns is exact", "[unit][cage]") {
  Cage cage;
  cage.vertices = {{1, 2, 3}};
  const std::vector<std::pair<double, Vec3>> turns = {
      {0, {1, 2, 3}},    {90, {-2, 1, 3}}, {180, {-1, -2, 3}},  {270, {2, -1, 3}},
      {-90, {2, -1, 3}}, {360, {1, 2, 3}}, {-180, {-1, -2, 3}}, {450, {-2, 1, 3}}};
  for (const auto& [angle_deg, expected] : turns) {
    CAPTURE(angle_deg);
    CHECK(placed(cage, {1, angle_deg, {}}).vertices[0] == expected);
  }
}

TEST_CASE("placement scales, then rotates, then translates", "[unit][cage]") {
  Cage cage;
  cage.vertices = {{1, 0, 1}};
  CHECK(placed(cage, {2, 90, {10, 20, 30}}).vertices[0] == Vec3{10, 22, 32});
  const Vec3 turned = placed(cage, {1, 30, {}}).vertices[0];
  // Two roundings of cos and sin: 2e-16 each.
  CHECK(turned.x == Approx(0.8660254037844386).margin(1e-15));
  CHECK(turned.y == Approx(0.5).margin(1e-15));
}

TEST_CASE("a placement keeps everything but the positions", "[property][cage]") {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> number(-100, 100);
  for (int round = 0; round < 50; ++round) {
    Cage cage = grid(3, 2);
    cage.creases = {{{0, 1}, 2.5}};
    cage.boundary = BoundaryRule::edge_and_corner;
    const Placement there = {2, number(random), {number(random), number(random), number(random)}};
    const Cage moved = placed(cage, there);
    CHECK(moved.face_corners == cage.face_corners);
    CHECK(moved.creases.size() == 1);
    CHECK(moved.boundary == cage.boundary);
    // A similarity: distances double. Coordinates up to 200 round at 3e-14.
    CHECK(distance(moved.vertices[0], moved.vertices[11]) ==
          Approx(2 * distance(cage.vertices[0], cage.vertices[11])).margin(1e-12));
  }
}
