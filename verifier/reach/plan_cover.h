#pragma once

#include <vector>

#include "model/geometry/vec2.h"

namespace limitgauge::verifier {

/// Points in plan, in mm, whose convex hull is meant.
using PlanHull = std::vector<model::Vec2>;

struct PlanDisc {
  double x = 0, y = 0, radius = 0;
};

/// The corners of the hull, in order.
PlanHull corners_of(PlanHull points);
/// Proof that the hull lies in the union of the discs: one after the other is taken off it, ever
/// the one that holds most of what is left (CERTIFICATE.md, section 4). False means "not proven".
/// The points are corners in order, as `corners_of` gives them.
bool covered(PlanHull hull, std::vector<PlanDisc> discs);

}  // namespace limitgauge::verifier
