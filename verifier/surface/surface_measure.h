#pragma once

#include "model/geometry/vec3.h"

namespace limitgauge::verifier {

class SurfaceTree;

/// Extremes of the surface itself in x, y and z, to 1e-10 mm, by branch and bound on the pieces.
model::Box3 exact_bounding_box(const SurfaceTree& tree);
/// Sum over the pieces by Gauss-Legendre quadrature, refined until two orders agree to 1e-7.
double surface_area_mm2(const SurfaceTree& tree);

}  // namespace limitgauge::verifier
