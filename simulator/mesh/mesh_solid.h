#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "model/mesh/triangle_mesh.h"

namespace limitgauge::simulator {

/// Signed distance to a solid and its gradient.
struct SolidSample {
  double distance = 0;  ///< mm, negative inside
  model::Vec3 gradient;
};

/// A plane over a place of a solid.
struct SolidCap {
  double depth = 0;    ///< mm, of the place under the plane
  model::Vec3 normal;  ///< outwards
};

/// The solid that a closed triangle mesh bounds: where its winding number is above zero. It is
/// counted along the vertical through the point with exact predicates and one rule for points over
/// edges and vertices (the point is taken to lie a little to +X, and far less to +Y, of where it
/// is), so that it holds for meshes that touch or overlap themselves. Where solids of one mesh
/// overlap, the distance is that to the nearest triangle, which may be one inside the other solid.
/// Immutable, cheap to copy.
class MeshSolid {
 public:
  /// Throws std::invalid_argument for a mesh that bounds no solid (model/mesh/mesh_defect.h).
  explicit MeshSolid(std::shared_ptr<const model::TriangleMesh> mesh);

  /// Exact distance to the nearest triangle (a relative error of a few roundings, 1e-12 mm on the
  /// surface), with the solid's sign. On the surface the gradient is the normal of a triangle
  /// there.
  SolidSample sample(const model::Vec3& p) const;
  /// Where the surface passes within `reach_mm` of p: a plane whose depth is nowhere within the
  /// reach less than the solid's. None where the solid is not found to be convex thereabouts.
  ///
  /// The plane is that of the nearest triangle, and no triangle that meets the ball of three times
  /// the reach about p rises above it. What is in the ball above the plane is then all in the
  /// solid or all outside, and one look says outside. A place within the reach and under the plane
  /// has its foot on it in the ball, beyond which is air: no deeper than that. A place over the
  /// plane is outside; the solid in the ball is at least as far as the plane, and the rest of it
  /// is at least twice the reach away, which is further than the plane.
  std::optional<SolidCap> cap(const model::Vec3& p, double reach_mm) const;
  /// Whether p lies in the solid; of its boundary, one side.
  bool contains(const model::Vec3& p) const;
  /// Distances at `out.size()` points of a vertical, `step_mm` apart upwards from p: in all no more
  /// than one look at the vertical, and each point begins where the one below ended.
  void distances_up(const model::Vec3& p, double step_mm, std::span<double> out) const;
  /// Heights at which the vertical at (x, y) enters and leaves the solid, ascending, an even
  /// number; the same sides as sample() sees.
  std::vector<double> crossings(double x_mm, double y_mm) const;
  const model::TriangleMesh& mesh() const;
  const model::Box3& box() const;
  double area_mm2() const;
  double volume_mm3() const;
  std::size_t memory_bytes() const;

 private:
  struct State;
  std::shared_ptr<const State> state_;
};

}  // namespace limitgauge::simulator
