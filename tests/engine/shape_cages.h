#pragma once
// Cages of shapes that strategies are tried on.

#include <array>
#include <cmath>
#include <numbers>

#include "tests/engine/cages.h"

namespace limitgauge::test {

/// A ring of `around` x `across` quads whose control points lie on a torus; its limit surface is a
/// little smaller than that torus.
inline model::Cage torus_cage(int around, int across, double major, double minor) {
  model::Cage cage;
  for (int i = 0; i < around; ++i)
    for (int j = 0; j < across; ++j) {
      const double a = 2 * std::numbers::pi * i / around, b = 2 * std::numbers::pi * j / across;
      const double r = major + minor * std::cos(b);
      cage.vertices.push_back({r * std::cos(a), r * std::sin(a), minor * std::sin(b)});
    }
  const auto at = [&](int i, int j) { return (i % around) * across + j % across; };
  for (int i = 0; i < around; ++i)
    for (int j = 0; j < across; ++j) {
      const std::array<model::Index, 4> corners = {at(i, j), at(i + 1, j), at(i + 1, j + 1),
                                                   at(i, j + 1)};
      cage.add_face(corners);
    }
  return cage;
}

/// A roof with an infinitely sharp ridge along Y: z = -slope |x|.
inline model::Cage ridge_cage(int n, double h, double slope) {
  model::Cage cage = grid_cage(n, h, [=](double x, double) { return -slope * std::abs(x) * h; });
  cage.boundary = model::BoundaryRule::edge_and_corner;
  for (int j = 0; j < n; ++j)
    cage.creases.push_back({{j * (n + 1) + n / 2, (j + 1) * (n + 1) + n / 2}, 10});
  return cage;
}

/// A block of square plan with a level top and upright walls, all edges rounded: rings of a square
/// cage one over the other, open below.
inline model::Cage block_cage(double half, double height, double rounding) {
  model::Cage cage;
  const int n = 4;  // vertices along a side are placed close to its ends
  const std::array<double, 5> along = {-half, -half + rounding, 0, half - rounding, half};
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i) cage.vertices.push_back({along[i], along[j], height});
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const std::array<model::Index, 4> corners = {j * 5 + i, j * 5 + i + 1, j * 5 + i + 6,
                                                   j * 5 + i + 5};
      cage.add_face(corners);
    }
  std::array<model::Index, 16> ring{};
  for (int k = 0; k < 16; ++k) {
    const int side = k / 4, t = k % 4;
    ring[k] = side == 0 ? t : side == 1 ? t * 5 + 4 : side == 2 ? 24 - t : (4 - t) * 5;
  }
  for (const double z : {height - rounding, 0.0}) {
    std::array<model::Index, 16> next{};
    for (int k = 0; k < 16; ++k) {
      const model::Vec3& p = cage.vertices[ring[k]];
      next[k] = static_cast<model::Index>(cage.vertices.size());
      cage.vertices.push_back({p.x, p.y, z});
    }
    for (int k = 0; k < 16; ++k) {
      const std::array<model::Index, 4> corners = {ring[k], next[k], next[(k + 1) % 16],
                                                   ring[(k + 1) % 16]};
      cage.add_face(corners);
    }
    ring = next;
  }
  return cage;
}

}  // namespace limitgauge::test
