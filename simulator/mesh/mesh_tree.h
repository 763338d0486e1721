#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "model/mesh/triangle_mesh.h"

namespace limitgauge::simulator {

/// The point of a triangle nearest to p.
model::Vec3 nearest_on_triangle(const std::array<model::Vec3, 3>& t, const model::Vec3& p);

/// The triangles of a mesh under a tree of boxes, four to a node. Immutable.
class MeshTree {
 public:
  using Triangle = std::array<model::Vec3, 3>;

  /// The mesh has at least one triangle, and all its vertices are finite.
  explicit MeshTree(const model::TriangleMesh& mesh);

  struct Nearest {
    std::uint32_t slot = 0;  ///< of the triangle in this tree
    model::Vec3 point;
    double distance_squared = 0;
  };
  /// `hint` is a triangle to look at first; it only saves time.
  Nearest nearest(const model::Vec3& p, std::uint32_t hint = 0) const;

  /// Calls `visit(slot)` for every triangle whose box the vertical at (x, y) meets at `z_from` or
  /// above, boundaries included.
  template <class Visit>
  void above(double x, double y, double z_from, Visit&& visit) const;

  /// Calls `visit(slot)` for the triangles whose boxes meet a cube about p, until it returns false.
  /// Whether it never did.
  template <class Visit>
  bool each_about(const model::Vec3& p, double half_edge, Visit&& visit) const;

  const Triangle& triangle(std::uint32_t slot) const { return triangles_[slot]; }
  std::size_t memory_bytes() const;

 private:
  static constexpr int kWide = 4;
  // A child with a count is that many triangles from `first` on; one without is the node `first`.
  // Unused children have an empty box, which nothing is near to.
  struct Node {
    std::array<std::array<double, kWide>, 3> low, high;
    std::array<std::uint32_t, kWide> first, count;
  };
  struct Builder;
  /// Visits the triangles of all leaves whose boxes `meets(node, child)`, until a visit says false.
  template <class Meets, class Visit>
  bool each_where(Meets&& meets, Visit&& visit) const;

  std::vector<Node> nodes_;
  std::vector<Triangle> triangles_;
};

template <class Meets, class Visit>
bool MeshTree::each_where(Meets&& meets, Visit&& visit) const {
  std::array<std::uint32_t, 128> stack;
  int depth = 0;
  stack[depth++] = 0;
  while (depth > 0) {
    const Node& node = nodes_[stack[--depth]];
    for (int k = 0; k < kWide; ++k) {
      if (!meets(node, k)) continue;
      if (node.count[k] == 0) stack[depth++] = node.first[k];
      for (std::uint32_t n = 0; n < node.count[k]; ++n)
        if (!visit(node.first[k] + n)) return false;
    }
  }
  return true;
}

template <class Visit>
bool MeshTree::each_about(const model::Vec3& p, double half_edge, Visit&& visit) const {
  const auto meets = [&](const Node& node, int k) {
    bool apart = false;
    for (int a = 0; a < 3; ++a)
      apart |= p[a] + half_edge < node.low[a][k] || p[a] - half_edge > node.high[a][k];
    return !apart;
  };
  return each_where(meets, visit);
}

template <class Visit>
void MeshTree::above(double x, double y, double z_from, Visit&& visit) const {
  const auto meets = [&](const Node& node, int k) {
    return x >= node.low[0][k] && x <= node.high[0][k] && y >= node.low[1][k] &&
           y <= node.high[1][k] && z_from <= node.high[2][k];
  };
  each_where(meets, [&](std::uint32_t triangle) {
    visit(triangle);
    return true;
  });
}

}  // namespace limitgauge::simulator
