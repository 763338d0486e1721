#pragma once

#include <optional>

#include "verifier/deviation.h"
#include "verifier/surface_cells.h"

namespace limitgauge::verifier {

struct ClosestPoint {
  SurfacePlace place;
  model::Vec3 normal;      ///< unit normal of S there
  double distance_mm = 0;  ///< unsigned
  /// The connection to the query leaves S along its normal: the foot of a perpendicular, not a
  /// point of the boundary or of a crease.
  bool perpendicular = false;
};

/// The point of the surface nearest to `p`, where it is no further than `within_mm`: search over
/// the boxes of the cells, Newton inside a cell with a fallback to splitting it. Positions are good
/// to 1e-10 mm.
std::optional<ClosestPoint> closest_point(const SurfaceCells& cells, const model::Vec3& p,
                                          double within_mm);

}  // namespace limitgauge::verifier
