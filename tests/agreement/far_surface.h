#pragma once

#include <vector>

#include "model/part/cage.h"

namespace limitgauge::tests {

/// A point of the limit surface by OpenSubdiv, at the parameters of the reference surface. In mm.
struct FarPoint {
  int patch = 0;
  double u = 0, v = 0;
  model::Vec3 position;
};
struct FarSurface {
  std::vector<bool> has_surface;  ///< by patch: no hole, as OpenSubdiv's refiner has it
  std::vector<FarPoint> points;   ///< of patches that have surface; each parameter once a patch
  int vertices_without_mask = 0;  ///< whose limits are not by Far's masks but by its refinement
};

/// OpenSubdiv's limits of the vertices that `levels` ≥ 1 uniform refinements give, in double
/// precision: by its limit masks, and where those are not exact (at the end of a crease and at a
/// vertex of valence two) by refining the star of the vertex until nothing is left. `levels` has to
/// use up all finite sharpness. Throws std::runtime_error where OpenSubdiv refuses the cage.
FarSurface far_surface(const model::Cage& cage, int levels);

}  // namespace limitgauge::tests
