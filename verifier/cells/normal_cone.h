#pragma once

#include <array>
#include <optional>

#include "verifier/surface/bezier.h"

namespace limitgauge::verifier {

/// A unit vector across a unit vector.
model::Vec3 across(const model::Vec3& n);

/// Bézier coefficients of S_u × S_v, of degree 5 in both (index 6·j + i, i along u), up to a common
/// positive factor.
std::array<model::Vec3, 36> normal_coefficients(const Bezier& cell);
/// Half angle of the cone round a unit axis that holds such coefficients, and so every normal of
/// the cell, whose direction is a positive combination of theirs; none where it is as wide as a
/// half space, or where a coefficient vanishes.
std::optional<double> normal_spread_rad(const std::array<model::Vec3, 36>& coefficients,
                                        const model::Vec3& axis);

}  // namespace limitgauge::verifier
