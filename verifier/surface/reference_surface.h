#pragma once

#include <memory>

#include "model/geometry/vec3.h"
#include "model/part/cage.h"
#include "verifier/surface/surface_rules.h"

namespace limitgauge::verifier {

/// Which approaches to a point share the tangent plane of a sample.
enum class TangentPlane {
  everywhere,   ///< all within the patch; on a crease all from this side of it
  off_creases,  ///< all but along the sharp edges that end the sector: the surface is not C1 there
  none          ///< the plane turns with the direction; given is the limit along the diagonal of
                ///< the patch (at an interior vertex of valence two: the mean plane)
};

/// A point of the limit surface: position in mm, derivatives in mm per unit, or unit squared, of
/// the patch's own parameters u and v in [0, 1], however finely the patch is refined there.
///
/// `normal` is the unit normal towards the machining side, as seen from this patch. Where two
/// pieces of a patch or two patches meet smoothly the derivatives agree to rounding, but for the
/// direction of the neighbour's parameters; where a sharp edge lies between them, each patch has
/// its own. Beside an extraordinary vertex second derivatives grow without bound.
///
/// At an irregular vertex (`irregular_vertex`: extraordinary, or the end or the bend of a crease)
/// no derivatives by u and v exist in general. There du and dv span the exact tangent plane, turned
/// so that du × dv points along the normal, and have no meaningful length; duu, duv and dvv are
/// zero and stand for nothing. `plane` says whether the plane is one. The normal is the zero vector
/// only where the control mesh itself is folded flat.
struct SurfaceSample {
  model::Vec3 position, du, dv, normal;
  model::Vec3 duu, duv, dvv;
  bool irregular_vertex = false;
  TangentPlane plane = TangentPlane::everywhere;
};

class SurfaceTree;

/// The exact Catmull-Clark limit surface of a cage: rational-free bicubic Bézier pieces, refined
/// locally around every irregularity until what is left is below double precision (design: Stam's
/// idea by explicit refinement). Shares no code with the engine. An immutable value, cheap to copy.
/// Patches are numbered as OpenSubdiv numbers faces: base faces in file order, an n-gon's corner
/// quads in order; hole faces keep their number but have no surface.
class ReferenceSurface {
 public:
  /// Throws std::invalid_argument for a cage with defects (see model::find_defects).
  explicit ReferenceSurface(const model::Cage& cage);

  int patch_count() const;
  /// False for holes, and for boundary faces under BoundaryRule::none.
  bool has_surface(int patch) const;
  /// u, v in [0, 1]. Error below 1e-12 of the model's size.
  SurfaceSample evaluate(int patch, double u, double v) const;
  /// Exact to 1e-9 mm: extremes of the surface, not of its control points.
  const model::Box3& bounding_box() const;
  /// By Gauss quadrature on the pieces; relative error below 1e-6.
  double area_mm2() const;

  /// What the surface was made by.
  const SurfaceRules& rules() const { return rules_; }

  const SurfaceTree& tree() const { return *tree_; }

 private:
  std::shared_ptr<const SurfaceTree> tree_;
  SurfaceRules rules_;
};

}  // namespace limitgauge::verifier
