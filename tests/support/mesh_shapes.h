#pragma once
// Closed triangle meshes whose solids are known in closed form.

#include <cmath>
#include <numbers>

#include "model/mesh/triangle_mesh.h"

namespace limitgauge::tests {

inline void append_mesh(model::TriangleMesh& mesh, const model::TriangleMesh& other) {
  const auto base = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), other.vertices.begin(), other.vertices.end());
  for (const auto& t : other.triangles)
    mesh.triangles.push_back({t[0] + base, t[1] + base, t[2] + base});
}

/// Twelve triangles.
inline model::TriangleMesh block_between(const model::Vec3& low, const model::Vec3& high) {
  model::TriangleMesh mesh;
  for (int k = 0; k < 8; ++k)
    mesh.vertices.push_back(
        {k & 1 ? high.x : low.x, k & 2 ? high.y : low.y, k & 4 ? high.z : low.z});
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return mesh;
}

inline model::TriangleMesh inside_out(model::TriangleMesh mesh) {
  for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
  return mesh;
}

/// A block with a hole in its middle that reaches no side.
inline model::TriangleMesh hollow_block(double half_mm, double half_hole_mm) {
  const model::Vec3 one{1, 1, 1};
  model::TriangleMesh mesh = block_between(one * -half_mm, one * half_mm);
  append_mesh(mesh, inside_out(block_between(one * -half_hole_mm, one * half_hole_mm)));
  return mesh;
}

/// Inscribed in a sphere: `bands` from pole to pole, `sectors` around, 2 (bands − 1) sectors
/// triangles.
inline model::TriangleMesh sphere_mesh(const model::Vec3& centre, double radius_mm, int bands,
                                       int sectors) {
  model::TriangleMesh mesh;
  mesh.vertices.push_back(centre + model::Vec3{0, 0, radius_mm});
  for (int b = 1; b < bands; ++b)
    for (int s = 0; s < sectors; ++s) {
      const double polar = std::numbers::pi * b / bands,
                   around = 2 * std::numbers::pi * s / sectors;
      mesh.vertices.push_back(centre + model::Vec3{std::sin(polar) * std::cos(around),
                                                   std::sin(polar) * std::sin(around),
                                                   std::cos(polar)} *
                                           radius_mm);
    }
  mesh.vertices.push_back(centre - model::Vec3{0, 0, radius_mm});
  const auto last = static_cast<std::uint32_t>(mesh.vertices.size() - 1);
  const auto at = [&](int b, int s) {
    return static_cast<std::uint32_t>(1 + (b - 1) * sectors + s % sectors);
  };
  for (int s = 0; s < sectors; ++s) {
    mesh.triangles.push_back({0, at(1, s), at(1, s + 1)});
    for (int b = 1; b + 1 < bands; ++b) {
      mesh.triangles.push_back({at(b, s), at(b + 1, s), at(b + 1, s + 1)});
      mesh.triangles.push_back({at(b, s), at(b + 1, s + 1), at(b, s + 1)});
    }
    mesh.triangles.push_back({last, at(bands - 1, s + 1), at(bands - 1, s)});
  }
  return mesh;
}

}  // namespace limitgauge::tests
