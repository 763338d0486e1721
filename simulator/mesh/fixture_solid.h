#pragma once

#include <memory>
#include <optional>

#include "model/mesh/triangle_mesh.h"
#include "simulator/mesh/mesh_tree.h"
#include "simulator/mesh/triangle_minimum.h"

namespace limitgauge::simulator {

/// A fixture's closed mesh. Immutable.
class FixtureSolid {
 public:
  /// Throws std::invalid_argument for a mesh that bounds no solid (model/mesh/mesh_defect.h).
  explicit FixtureSolid(std::shared_ptr<const model::TriangleMesh> mesh);

  /// The place of the fixture's surface where the swept distance of `body` is least, to within
  /// `precision_mm`; none if it is nowhere below `bound`.
  std::optional<SurfacePlace> nearest(const CutterProfile& body, const SweptMove& move,
                                      double bound, double precision_mm) const;
  /// Whether `p`, which is not on the surface, lies inside: the surface goes around it.
  bool encloses(const model::Vec3& p) const;
  const model::Box3& box() const { return tree_.box(); }

 private:
  MeshTree tree_;
};

}  // namespace limitgauge::simulator
