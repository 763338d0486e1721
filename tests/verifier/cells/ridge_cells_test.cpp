#include "verifier/cells/ridge_cells.h"

#include <algorithm>
#include <cmath>

#include "tests/support/cages.h"
#include "tests/support/catch.h"
#include "verifier/surface/reference_surface.h"

namespace limitgauge::verifier {

using namespace tests;
using model::Vec3;

namespace {

/// A crease that turns in the middle of a bent sheet: one face on its one side there, three on the
/// other.
model::Cage turning_crease_cage() {
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
  return cage;
}

/// At u of a polynomial of degree 5.
Vec3 at(std::array<Vec3, 6> c, double u) {
  for (int last = 5; last > 0; --last)
    for (int k = 0; k < last; ++k) c[k] = c[k] * (1 - u) + c[k + 1] * u;
  return c[0];
}

/// How far the normals of an edge's cell are from the segment n₀ ± fan, at most.
double most_beside_fan(const RidgeCell& ridge, const OffsetCell& o) {
  double most = 0;
  for (double u = 0; u <= 1; u += 0.125)
    for (double share = 0; share <= 1; share += 0.0625) {
      const Vec3 n =
          normalized(at(ridge.normals[0], u) * (1 - share) + at(ridge.normals[1], u) * share);
      const double x = std::clamp(dot(n - o.normal, o.fan) / dot(o.fan, o.fan), -1.0, 1.0);
      most = std::max(most, distance(n, o.normal + o.fan * x));
    }
  return most;
}

}  // namespace

TEST_CASE("normals of a sharp edge stay those of its faces down to an irregular vertex",
          "[property]") {
  const ReferenceSurface surface(turning_crease_cage());
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

TEST_CASE("a fan is as wide as it is anywhere along the edge", "[property]") {
  const ReferenceSurface surface(turning_crease_cage());
  for (const RidgeCell& cell : ridge_cells(surface.tree(), 0.4)) {
    if (cell.count != 2) continue;
    for (double u = 0; u <= 1; u += 0.0625)
      CHECK(angle_between(at(cell.normals[0], u), at(cell.normals[1], u)) <=
            cell.fan_rad() + 1e-12);
  }
  // A valley on one side of the middle, a ridge on the other, none in between.
  RidgeCell crossing;
  for (int k = 0; k < 6; ++k) {
    crossing.normals[0][k] = {0, 0, 1};
    crossing.normals[1][k] = {0, 0.02 * k - 0.05, 1};
  }
  CHECK(crossing.fan_rad() >= std::atan(0.05));
  CHECK(crossing.fan_rad() <= 1.01 * std::atan(0.05));
}

TEST_CASE("normals of a sharp edge lie within the remainder of their fan", "[property]") {
  const bool straight = GENERATE(true, false);
  const ReferenceSurface surface(straight ? sharp_cube(true) : turning_crease_cage());
  std::vector<RidgeCell> cells = ridge_cells(surface.tree(), 0.4);
  int fans = 0;
  for (int halvings = 0; halvings < 6; ++halvings) {
    std::vector<RidgeCell> halves;
    for (const RidgeCell& cell : cells) {
      if (cell.count != 2) continue;
      const OffsetCell o = cell.offset();
      if (length(o.fan) > 0) {
        ++fans;
        CHECK(most_beside_fan(cell, o) <= o.remainder + 1e-12);
        // Between planes nothing turns along the edge: second order in the angle.
        if (straight) CHECK(o.remainder < 1.01 * (1 / std::cos(o.spread_rad) - 1) + 1e-12);
      }
      for (const RidgeCell& half : cell.halved(halvings % 2 == 0 ? 100 : 1e-3))
        halves.push_back(half);
    }
    cells = std::move(halves);
  }
  CHECK(fans > 500);
}

}  // namespace limitgauge::verifier
