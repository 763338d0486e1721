#pragma once

#include <cstddef>
#include <memory>

#include "model/base/run_control.h"
#include "model/mesh/triangle_mesh.h"
#include "model/part/cage.h"
#include "verifier/surface/surface_rules.h"
#include "verifier/surface/surface_sample.h"

namespace limitgauge::verifier {

class SurfaceTree;

/// The exact Catmull-Clark limit surface of a cage: rational-free bicubic Bézier pieces, refined
/// locally around every irregularity until what is left is below double precision (design: Stam's
/// idea by explicit refinement). Shares no code with the engine. An immutable value, cheap to copy.
/// Patches are numbered as OpenSubdiv numbers faces: base faces in file order, an n-gon's corner
/// quads in order; hole faces keep their number but have no surface.
class ReferenceSurface {
 public:
  /// Throws std::invalid_argument for a cage with defects (see model::find_defects), Interrupted
  /// when `control` asks to stop. The same surface for any number of threads.
  explicit ReferenceSurface(const model::Cage& cage, const model::RunControl& control = {});
  /// The facets of a mesh, which are the truth: patches are numbered as those of a cage whose faces
  /// are its triangles, three each, and every edge is sharp. Throws std::invalid_argument for a
  /// mesh that is no two-manifold, or not oriented alike; it need not be closed.
  explicit ReferenceSurface(const model::TriangleMesh& mesh, const model::RunControl& control = {});

  int patch_count() const;
  /// False for holes, and for faces that BoundaryRule::none leaves out.
  bool has_surface(int patch) const;
  /// u, v in [0, 1]. Error below 1e-12 of the model's size.
  SurfaceSample evaluate(int patch, double u, double v) const;
  /// Exact to 1e-9 mm: extremes of the surface, not of its control points.
  const model::Box3& bounding_box() const;
  /// By Gauss quadrature on the pieces; relative error below 1e-6.
  double area_mm2() const;
  std::size_t memory_bytes() const;

  /// What the surface was made by.
  const SurfaceRules& rules() const { return rules_; }

  const SurfaceTree& tree() const { return *tree_; }

 private:
  std::shared_ptr<const SurfaceTree> tree_;
  SurfaceRules rules_;
};

}  // namespace limitgauge::verifier
