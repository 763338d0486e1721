#pragma once

#include "witness/far_refinement.h"

namespace limitgauge::witness {

/// Refinements of a star after which it is a point: it shrinks to 0.6545 a step at most (the
/// subdominant eigenvalue of high valences), and 0.6545^100 is below any rounding.
inline constexpr int kStarSteps = 100;

/// The limit of vertex `v` of the last level of `far`, where its positions are `at`, for vertices
/// without an exact mask: by refining its star, which nothing outside has a part in, until its
/// sharpness is used up; then by Far's mask, or where there is none, until nothing is left of it.
model::Vec3 star_limit(const FarRefinement& far, const Primvars& at, model::Index v);

}  // namespace limitgauge::witness
