#pragma once
// Closed triangle meshes of solids whose distance is known in closed form.

#include <cmath>
#include <functional>
#include <memory>
#include <numbers>

#include "model/mesh/triangle_mesh.h"
#include "model/part/stock.h"

namespace limitgauge::tests {

inline model::Stock mesh_stock(model::TriangleMesh mesh) {
  return model::MeshStock{std::make_shared<const model::TriangleMesh>(std::move(mesh)), "test", 0};
}

/// A quadrilateral, counter-clockwise from outside, as two triangles.
inline void add_quad(model::TriangleMesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c,
                     std::uint32_t d) {
  mesh.triangles.push_back({a, b, c});
  mesh.triangles.push_back({a, c, d});
}

inline model::TriangleMesh box_mesh(const model::Vec3& low, const model::Vec3& size) {
  model::TriangleMesh mesh;
  for (int k = 0; k < 8; ++k)
    mesh.vertices.push_back(
        low + model::Vec3{k & 1 ? size.x : 0, k & 2 ? size.y : 0, k & 4 ? size.z : 0});
  add_quad(mesh, 0, 2, 3, 1), add_quad(mesh, 4, 5, 7, 6), add_quad(mesh, 0, 1, 5, 4);
  add_quad(mesh, 2, 6, 7, 3), add_quad(mesh, 0, 4, 6, 2), add_quad(mesh, 1, 3, 7, 5);
  return mesh;
}

/// Between the height `bottom_mm` and z = top(x, y) over [−half, half]², in n × n squares.
inline model::TriangleMesh block_under(double half_mm, int n, double bottom_mm,
                                       const std::function<double(double, double)>& top) {
  model::TriangleMesh mesh;
  const auto row = static_cast<std::uint32_t>(n + 1), layer = row * row;
  for (const bool upper : {false, true})
    for (int j = 0; j <= n; ++j)
      for (int i = 0; i <= n; ++i) {
        const double x = half_mm * (2.0 * i / n - 1), y = half_mm * (2.0 * j / n - 1);
        mesh.vertices.push_back({x, y, upper ? top(x, y) : bottom_mm});
      }
  const auto at = [&](int i, int j, bool upper) {
    return static_cast<std::uint32_t>(j) * row + static_cast<std::uint32_t>(i) +
           (upper ? layer : 0);
  };
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      add_quad(mesh, at(i, j, true), at(i + 1, j, true), at(i + 1, j + 1, true),
               at(i, j + 1, true));
      add_quad(mesh, at(i, j, false), at(i, j + 1, false), at(i + 1, j + 1, false),
               at(i + 1, j, false));
    }
  for (int k = 0; k < n; ++k) {
    add_quad(mesh, at(k, 0, false), at(k + 1, 0, false), at(k + 1, 0, true), at(k, 0, true));
    add_quad(mesh, at(k + 1, n, false), at(k, n, false), at(k, n, true), at(k + 1, n, true));
    add_quad(mesh, at(0, k + 1, false), at(0, k, false), at(0, k, true), at(0, k + 1, true));
    add_quad(mesh, at(n, k, false), at(n, k + 1, false), at(n, k + 1, true), at(n, k, true));
  }
  return mesh;
}

/// An upright prism over a regular polygon of `sides` corners, the first of them on +X.
inline model::TriangleMesh prism_mesh(const model::Vec3& base, double radius_mm, double height_mm,
                                      int sides) {
  model::TriangleMesh mesh;
  const auto n = static_cast<std::uint32_t>(sides);
  for (const double z : {0.0, height_mm})
    for (int k = 0; k < sides; ++k) {
      const double angle = 2 * std::numbers::pi * k / sides;
      mesh.vertices.push_back(
          base + model::Vec3{radius_mm * std::cos(angle), radius_mm * std::sin(angle), z});
    }
  for (std::uint32_t k = 0; k < n; ++k) add_quad(mesh, k, (k + 1) % n, n + (k + 1) % n, n + k);
  for (std::uint32_t k = 1; k + 1 < n; ++k) {
    mesh.triangles.push_back({0, k + 1, k});
    mesh.triangles.push_back({n, n + k, n + k + 1});
  }
  return mesh;
}

/// All triangles of both.
inline model::TriangleMesh joined(model::TriangleMesh a, const model::TriangleMesh& b) {
  const auto shift = static_cast<std::uint32_t>(a.vertices.size());
  a.vertices.insert(a.vertices.end(), b.vertices.begin(), b.vertices.end());
  for (const auto& t : b.triangles)
    a.triangles.push_back({t[0] + shift, t[1] + shift, t[2] + shift});
  return a;
}

inline model::TriangleMesh inside_out(model::TriangleMesh mesh) {
  for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
  return mesh;
}

inline model::TriangleMesh mapped(model::TriangleMesh mesh,
                                  const std::function<model::Vec3(const model::Vec3&)>& map) {
  for (model::Vec3& v : mesh.vertices) v = map(v);
  return mesh;
}

/// A square plate about the origin, from z = 0 up, with a hole through it of `sides` sides (a
/// multiple of four) whose corners are `radius_mm` from its middle, the first at so many steps from
/// one to the next.
inline model::TriangleMesh plate_with_hole(int sides, double radius_mm, double half_mm,
                                           double height_mm, double first_step = 0) {
  model::TriangleMesh mesh;
  const auto n = static_cast<std::uint32_t>(sides);
  for (const double z : {0.0, height_mm}) {
    for (int i = 0; i < sides; ++i) {
      const double a = 2 * std::numbers::pi * (i + first_step) / sides;
      mesh.vertices.push_back({radius_mm * std::cos(a), radius_mm * std::sin(a), z});
    }
    for (const auto& [x, y] : {std::pair{1, 1}, {-1, 1}, {-1, -1}, {1, -1}})
      mesh.vertices.push_back({x * half_mm, y * half_mm, z});
  }
  const std::uint32_t up = n + 4;
  for (std::uint32_t side = 0; side < 4; ++side) {
    const std::uint32_t corner = n + side, next = n + (side + 1) % 4;
    for (std::uint32_t i = side * n / 4; i < (side + 1) * n / 4; ++i) {
      const std::uint32_t j = (i + 1) % n;
      for (const auto& t : {std::array{up + j, up + i, up + corner},
                            {i, j, corner},
                            {j, i, up + i},
                            {j, up + i, up + j}})
        mesh.triangles.push_back(t);
    }
    const std::uint32_t last = (side + 1) * n / 4 % n;
    for (const auto& t : {std::array{up + last, up + corner, up + next},
                          {last, next, corner},
                          {corner, next, up + next},
                          {corner, up + next, up + corner}})
      mesh.triangles.push_back(t);
  }
  return mesh;
}

}  // namespace limitgauge::tests
