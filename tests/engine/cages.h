#pragma once
// Cages made in code whose limit surfaces are known in closed form.

#include <cmath>
#include <cstddef>
#include <functional>
#include <vector>

#include "model/part/cage.h"

namespace limitgauge::test {

/// A regular grid of (n + 1)² vertices at x, y = (i - n / 2) h; height(i, j) in grid indices.
inline model::Cage grid_cage(int n, double h, const std::function<double(double, double)>& height) {
  model::Cage cage;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i) {
      const double x = i - n / 2.0, y = j - n / 2.0;
      cage.vertices.push_back({x * h, y * h, height(x, y)});
    }
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const model::Index at = j * (n + 1) + i;
      const model::Index corners[] = {at, at + 1, at + n + 2, at + n + 1};
      cage.add_face(corners);
    }
  return cage;
}

/// z = k (x² + y²) on the inner part of the grid: control heights k h² (i² - 1/3) reproduce x². The
/// outermost ring of faces is a hole, since boundary rules would bend the surface there.
inline model::Cage paraboloid_cage(int n, double h, double k) {
  model::Cage cage = grid_cage(
      n, h, [=](double x, double y) { return k * h * h * (x * x - 1.0 / 3 + y * y - 1.0 / 3); });
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i)
      if (i == 0 || j == 0 || i == n - 1 || j == n - 1) cage.holes.push_back(j * n + i);
  return cage;
}

/// A bilinear function survives the boundary rules: z = a x + b y + c x y over the full square.
inline model::Cage bilinear_cage(int n, double h, double a, double b, double c) {
  model::Cage cage = grid_cage(
      n, h, [=](double x, double y) { return a * x * h + b * y * h + c * x * y * h * h; });
  cage.boundary = model::BoundaryRule::edge_and_corner;
  return cage;
}

/// The cube with corners at ±half.
inline model::Cage cube_cage(double half) {
  model::Cage cage;
  for (int v = 0; v < 8; ++v)
    cage.vertices.push_back({v & 1 ? half : -half, v & 2 ? half : -half, v & 4 ? half : -half});
  const model::Index faces[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                    {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  for (const auto& face : faces) cage.add_face(face);
  return cage;
}

/// A flat disc of `valence` quads around one vertex in the plane z = slope x.
inline model::Cage flat_star_cage(int valence, double radius, double slope) {
  model::Cage cage;
  cage.vertices.push_back({0, 0, 0});
  for (int i = 0; i < 2 * valence; ++i) {
    const double angle = 3.14159265358979323846 * i / valence;
    const double x = radius * std::cos(angle), y = radius * std::sin(angle);
    cage.vertices.push_back({x, y, slope * x});
  }
  for (int i = 0; i < valence; ++i) {
    const model::Index corners[] = {0, 2 * i + 1, 2 * i + 2, 1 + (2 * i + 2) % (2 * valence)};
    cage.add_face(corners);
  }
  return cage;
}

}  // namespace limitgauge::test
