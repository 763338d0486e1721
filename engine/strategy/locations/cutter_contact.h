#pragma once

#include <algorithm>
#include <array>
#include <limits>

#include "engine/strategy/locations/cutter_shape.h"
#include "engine/tolerance.h"
#include "model/geometry/vec3.h"

namespace limitgauge::engine::strategy {

using model::Vec3;

/// The greatest of the lifts met so far. What cannot exceed `known` need not be looked at.
struct GreatestLift {
  double value = -std::numeric_limits<double>::infinity();
  double known = -std::numeric_limits<double>::infinity();
  double slack = 0;

  void take(double lift) {
    if (lift <= value) return;
    value = lift;
    known = std::max(known, lift + slack);
  }
};

/// The lift of one place or move over one triangle. With the axis of the body through the origin,
/// a point w asks for the lift w.z - p(|w.xy|); that is concave in w, since p is convex and does
/// not fall, so its greatest over a triangle lies at the one contact inside or on an edge. A move
/// from a to b over the triangle is the same question for the convex set {q - c: q of the
/// triangle, c of the move}, a prism: its upper side is made of the triangle seen from a and from
/// b and of the parallelograms that its edges sweep.
using Corners = std::array<Vec3, 3>;
void lift_over_triangle(const CutterShape& shape, const Corners& seen, GreatestLift& greatest);
void lift_over_prism(const CutterShape& shape, const Corners& seen_from_a,
                     const Corners& seen_from_b, GreatestLift& greatest);

}  // namespace limitgauge::engine::strategy
