#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "model/geometry/box_tree.h"
#include "model/mesh/triangle_mesh.h"

namespace limitgauge::verifier {

using Triangle = std::array<model::Vec3, 3>;

/// The point of a triangle nearest to `p`, also of one without area. The verifier's own, not the
/// simulator's: the two instruments are held against each other and share no distance.
model::Vec3 nearest_on_triangle(const Triangle& t, const model::Vec3& p);

/// The triangles of a mesh under a tree of boxes, numbered in the order of its leaves.
class TriangleTree {
 public:
  /// Throws std::invalid_argument for a mesh without triangles, with a vertex number out of range
  /// or a coordinate that is not finite.
  explicit TriangleTree(const model::TriangleMesh& mesh);

  struct Foot {
    std::uint32_t triangle = 0;
    model::Vec3 point;
    double distance_mm = 0;
  };
  /// The nearest point of the mesh; none where it is further away than `within_mm`.
  std::optional<Foot> nearest(const model::Vec3& p,
                              double within_mm = std::numeric_limits<double>::infinity()) const;

  /// The first t in [0, limit_mm] at which p + t·ray, a unit vector, comes within `within_mm` > 0
  /// of the mesh; the limit where it never does.
  double first_near(const model::Vec3& p, const model::Vec3& ray, double limit_mm,
                    double within_mm) const;

  const std::vector<Triangle>& triangles() const { return triangles_; }
  const std::vector<model::BoxNode>& nodes() const { return nodes_; }
  const model::Box3& box() const { return nodes_.front().box; }

 private:
  std::vector<Triangle> triangles_;
  std::vector<model::BoxNode> nodes_;
};

}  // namespace limitgauge::verifier
