#pragma once

#include <array>
#include <optional>
#include <span>

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

/// How the 4 × 4 control points of that polynomial come of a neighbourhood's points, whatever these
/// are: in this order, each a point, or the reflection 2a − b of two entries that are there
/// already.
struct RegularGrid {
  struct Entry {
    int to = 0;  ///< of the grid
    bool reflected = false;
    model::Index a = 0, b = 0;  ///< a point of the neighbourhood, or two entries of the grid
  };
  std::array<Entry, 16> entries;
};
/// Empty where regular_piece is.
std::optional<RegularGrid> regular_grid(const Neighbourhood& n);
Bezier piece_of(const RegularGrid& grid, std::span<const model::Vec3> points);

/// Whether corner `k` of face 0 keeps the face from being one polynomial.
bool is_irregular_corner(const Neighbourhood& n, int k);

}  // namespace limitgauge::verifier
