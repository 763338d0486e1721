#pragma once

#include <memory>
#include <vector>

#include "engine/model/triangle_mesh.h"

namespace limitgauge::simulator {

/// Signed distance to a solid and its gradient.
struct SolidSample {
  double distance = 0;  ///< mm, negative inside
  model::Vec3 gradient;
};

/// The solid that a closed triangle mesh bounds. The sign is the winding number along the vertical
/// through the point, counted with one consistent rule on shared edges: it holds for meshes that
/// touch or overlap themselves. Immutable, cheap to copy.
class MeshSolid {
 public:
  /// Throws std::invalid_argument for a mesh that is not closed or not finite.
  explicit MeshSolid(std::shared_ptr<const model::TriangleMesh> mesh);

  /// Exact distance to the nearest triangle, with the solid's sign.
  SolidSample sample(const model::Vec3& p) const;
  /// Heights at which the vertical at (x, y) enters and leaves the solid, ascending, an even
  /// number.
  std::vector<double> crossings(double x_mm, double y_mm) const;
  const model::TriangleMesh& mesh() const;
  double area_mm2() const;
  double volume_mm3() const;
  std::size_t memory_bytes() const;

 private:
  struct State;
  std::shared_ptr<const State> state_;
};

}  // namespace limitgauge::simulator
