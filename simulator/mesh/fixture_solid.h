#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "model/mesh/triangle_mesh.h"
#include "simulator/mesh/triangle_minimum.h"

namespace limitgauge::simulator {

/// A fixture's closed mesh in a tree of boxes over its triangles. Immutable.
class FixtureSolid {
 public:
  /// Throws std::invalid_argument for a mesh that is missing, empty, not finite or not closed.
  explicit FixtureSolid(std::shared_ptr<const model::TriangleMesh> mesh);

  /// The place of the fixture's surface where the swept distance of `body` is least, to within
  /// `precision_mm`; none if it is nowhere below `bound`.
  std::optional<SurfacePlace> nearest(const CutterProfile& body, const SweptMove& move,
                                      double bound, double precision_mm) const;
  /// Whether `p`, which is not on the surface, lies inside: the winding number along the vertical
  /// above it, with one rule for what lies on an edge, is not zero.
  bool encloses(const model::Vec3& p) const;
  const model::Box3& box() const { return nodes_.front().box; }

 private:
  struct Node {
    model::Box3 box;
    std::uint32_t first = 0;  // first triangle of a leaf, or the first of two child nodes
    std::uint32_t count = 0;  // triangles of a leaf, 0 for an inner node
  };
  void build(std::uint32_t node, std::uint32_t begin, std::uint32_t end);
  TriangleCorners corners(std::uint32_t at) const;

  std::shared_ptr<const model::TriangleMesh> mesh_;
  std::vector<std::uint32_t> order_;  // triangles as the leaves hold them
  std::vector<Node> nodes_;
};

}  // namespace limitgauge::simulator
