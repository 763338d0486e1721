#pragma once

#include <array>
#include <optional>

#include "simulator/swept_distance.h"

namespace limitgauge::simulator {

using TriangleCorners = std::array<model::Vec3, 3>;

/// A place and the swept distance there.
struct SurfacePlace {
  model::Vec3 point;
  double distance = 0;
};

/// The place of a triangle where the swept distance is least, to within `precision_mm`; none if it
/// is nowhere below `bound`. The distance is convex: over a part of the triangle it is nowhere
/// below its tangent at the part's centre, whose least value is at a corner, and the parts are
/// halved until none can be lower by more than the precision.
std::optional<SurfacePlace> least_on_triangle(const CutterProfile& body, const SweptMove& move,
                                              const TriangleCorners& triangle, double bound,
                                              double precision_mm);

}  // namespace limitgauge::simulator
