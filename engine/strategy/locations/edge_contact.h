#pragma once

#include "engine/strategy/locations/cutter_contact.h"

namespace limitgauge::engine::strategy {

/// Lift over one segment, see lift_over_triangle(). Closed forms but for rings, where a bracketed
/// Newton search ends in an upper bound that its tangent proves by concavity.
void lift_over_edge(const CutterShape& shape, const Vec3& from, const Vec3& to,
                    GreatestLift& greatest);

}  // namespace limitgauge::engine::strategy
