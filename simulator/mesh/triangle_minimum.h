#pragma once

#include <array>
#include <optional>

#include "simulator/sweep/swept_distance.h"

namespace limitgauge::simulator {

using TriangleCorners = std::array<model::Vec3, 3>;

/// A place and the swept distance there.
struct SurfacePlace {
  model::Vec3 point;
  double distance = 0;
};

/// The place of a triangle where the swept distance is least, to within `precision_mm`; none if it
/// is nowhere below `bound` by more than the precision.
///
/// The distance f is convex, so that what is below a value v lies where the tangent at c is:
/// f(c) + ∇f·(x − c) <= v. Starting with the triangle, a polygon is cut at its centre of gravity in
/// this way until nothing is left. Each cut takes at least 4/9 of its area away, whatever f
/// is (Levin 1965, Grünbaum 1960), so that some fifty steps are enough.
std::optional<SurfacePlace> least_on_triangle(const CutterProfile& body, const SweptMove& move,
                                              const TriangleCorners& triangle, double bound,
                                              double precision_mm);

}  // namespace limitgauge::simulator
