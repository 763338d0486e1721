#pragma once

#include <array>
#include <optional>

#include "verifier/bezier.h"

namespace limitgauge::verifier {

/// A cone that holds every normal of a cell: unit axis and half angle. The normal S_u × S_v is a
/// Bézier patch of degree (5, 5), and its directions lie in the cone of its coefficients.
struct NormalCone {
  model::Vec3 axis;
  double half_angle_rad = 0;
};
std::optional<NormalCone> normal_cone(const Bezier& cell);
/// The same round a given unit axis.
std::optional<NormalCone> normal_cone(const Bezier& cell, const model::Vec3& axis);

/// Bézier coefficients of S_u × S_v, of degree 5 in both (index 6·j + i, i along u), up to a common
/// positive factor.
std::array<model::Vec3, 36> normal_coefficients(const Bezier& cell);
/// The cone round a unit axis that holds such coefficients; none where it is as wide as a half
/// space, or where a coefficient vanishes.
std::optional<NormalCone> cone_round(const std::array<model::Vec3, 36>& coefficients,
                                     const model::Vec3& axis);

}  // namespace limitgauge::verifier
