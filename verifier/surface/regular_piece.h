#pragma once

#include <optional>

#include "verifier/surface/bezier.h"
#include "verifier/surface/neighbourhood.h"

namespace limitgauge::verifier {

/// The limit surface over face 0 where it is one bicubic polynomial: all four corners ordinary, or
/// on a boundary or infinitely sharp crease with two faces on this side, or infinitely sharp with
/// this face alone between two such edges. There the boundary rules equal a B-spline whose outer
/// control points are reflections, P₋₁ = 2P₀ − P₁: the reflected row stays reflected under
/// refinement and reproduces the masks (1/2, 1/2) and (1/8, 3/4, 1/8).
/// Empty where the face has to be refined first.
std::optional<Bezier> regular_piece(const Neighbourhood& n);

/// Whether corner `k` of face 0 keeps the face from being one polynomial.
bool is_irregular_corner(const Neighbourhood& n, int k);

}  // namespace limitgauge::verifier
