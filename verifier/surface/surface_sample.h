#pragma once

#include "model/geometry/vec3.h"

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

}  // namespace limitgauge::verifier
