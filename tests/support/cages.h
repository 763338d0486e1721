#pragma once
// Cages made in code whose limit surfaces are known in closed form.

#include <array>
#include <cmath>
#include <functional>
#include <numbers>

#include "model/part/cage.h"

namespace limitgauge::tests {

/// A grid of (nx + 1) × (ny + 1) vertices; `at(i, j)` gives the position.
inline model::Cage grid_cage(int nx, int ny, const std::function<model::Vec3(int, int)>& at,
                             model::BoundaryRule rule) {
  model::Cage cage;
  cage.name = "grid";
  cage.boundary = rule;
  for (int j = 0; j <= ny; ++j)
    for (int i = 0; i <= nx; ++i) cage.vertices.push_back(at(i, j));
  for (int j = 0; j < ny; ++j)
    for (int i = 0; i < nx; ++i) {
      const model::Index a = j * (nx + 1) + i;
      cage.add_face(std::array<model::Index, 4>{a, a + 1, a + nx + 2, a + nx + 1});
    }
  return cage;
}

/// z = slope_x·x + slope_y·y over [−half, half]², corners included.
inline model::Cage plane_cage(double half_mm, double slope_x, double slope_y) {
  const int n = 4;
  return grid_cage(
      n, n,
      [=](int i, int j) {
        const double x = half_mm * (2.0 * i / n - 1), y = half_mm * (2.0 * j / n - 1);
        return model::Vec3{x, y, slope_x * x + slope_y * y};
      },
      model::BoundaryRule::edge_and_corner);
}

/// z = k·(x² + y²) over [−half, half]²: control heights k·h²·(i² + j² − 2/3), since a uniform cubic
/// B-spline with coefficients i² is t² + 1/3. The outermost ring of faces carries no surface.
inline model::Cage paraboloid_cage(double half_mm, double k) {
  const int n = 6;
  const double h = 2 * half_mm / n;
  return grid_cage(
      n + 2, n + 2,
      [=](int i, int j) {
        const double a = i - 1 - n / 2.0, b = j - 1 - n / 2.0;
        return model::Vec3{a * h, b * h, k * h * h * (a * a + b * b - 2.0 / 3)};
      },
      model::BoundaryRule::none);
}

/// z(x) over [−half, half]², straight along y, from the control heights of a cubic B-spline.
inline model::Cage profile_cage(int n, double half_mm,
                                const std::function<double(double)>& control) {
  const double h = 2 * half_mm / n;
  return grid_cage(
      n + 2, n + 2,
      [=](int i, int j) {
        const double a = i - 1 - n / 2.0, b = j - 1 - n / 2.0;
        return model::Vec3{a * h, b * h, control(a * h)};
      },
      model::BoundaryRule::none);
}

/// z = k·x² over [−half, half]², straight along y; control heights as in `paraboloid_cage`.
inline model::Cage trough_cage(double half_mm, double k) {
  const int n = 4;
  const double h = 2 * half_mm / n;
  return profile_cage(n, half_mm, [=](double x) { return k * (x * x - h * h / 3); });
}

/// The cube [−1, 1]³, faces outwards. Limit of a control vertex: 1/2 of it.
inline model::Cage cube_cage() {
  model::Cage cage;
  cage.name = "cube";
  for (int k = 0; k < 8; ++k)
    cage.vertices.push_back({k & 1 ? 1.0 : -1.0, k & 2 ? 1.0 : -1.0, k & 4 ? 1.0 : -1.0});
  const std::array<std::array<model::Index, 4>, 6> faces = {
      {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
  for (const auto& f : faces) cage.add_face(f);
  return cage;
}

/// A cube whose edges and corners are sharp: all of them, or those of two opposite faces.
inline model::Cage sharp_cube(bool all) {
  model::Cage cage = cube_cage();
  for (int a = 0; a < 8; ++a)
    for (const int bit : {1, 2, 4})
      if ((a & bit) == 0 && (all || bit != 4)) cage.creases.push_back({{a, a | bit}, 10});
  return cage;
}

inline model::Cage scaled(model::Cage cage, double by) {
  for (model::Vec3& v : cage.vertices) v *= by;
  return cage;
}

/// A vertex of `valence` quads in two rings, waved so that the limit surface is not flat. Open.
inline model::Cage star_cage(int valence, double wave_mm) {
  model::Cage cage;
  cage.name = "star";
  cage.vertices.push_back({0, 0, wave_mm});
  const auto ring_point = [&](double turn, double radius) {
    const double angle = 2 * std::numbers::pi * turn / valence;
    return model::Vec3{radius * std::cos(angle), radius * std::sin(angle),
                       wave_mm * std::cos(3 * angle + radius)};
  };
  // First ring: spoke ends and diagonals in turn; second ring beyond them.
  for (const double scale : {1.0, 2.0})
    for (int k = 0; k < valence; ++k) {
      cage.vertices.push_back(ring_point(k, 10 * scale));
      cage.vertices.push_back(ring_point(k + 0.5, 13 * scale));
    }
  const int round = 2 * valence;
  const auto inner = [&](int k) { return 1 + (k + round) % round; };
  const auto outer = [&](int k) { return 1 + round + (k + round) % round; };
  for (int k = 0; k < valence; ++k)
    cage.add_face(std::array<model::Index, 4>{0, inner(2 * k), inner(2 * k + 1), inner(2 * k + 2)});
  for (int k = 0; k < round; ++k)
    cage.add_face(std::array<model::Index, 4>{inner(k), outer(k), outer(k + 1), inner(k + 1)});
  return cage;
}

}  // namespace limitgauge::tests
