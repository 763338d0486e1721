#pragma once

#include <array>

#include "engine/surface/cell_patch.h"

namespace limitgauge::engine::surface {

/// Bounds on the distance between a patch and its triangulated limit mesh (each cell split along
/// its first diagonal), mm.
struct ChordBound {
  double limit_mm = 0;   ///< of the limit surface
  double offset_mm = 0;  ///< of the surface moved out along its normals, but for the corners
  /// The same over the quarter at each corner: normals may turn ever faster towards a vertex.
  std::array<double, 4> corner_offset_mm{};
};

/// Bounds at the patch's present depth, from second differences seen along each triangle's normal:
/// a linear interpolant leaves a function by at most (D_uu + 2 D_uv + D_vv) / 8 (Filip, Magedson
/// and Markot). On cells whose 4×4 control points are complete the second derivatives of the limit
/// surface lie in the hull of the control net's second differences, so the bound is rigorous;
/// cells at extraordinary corners and the offset use the differences of the limit points
/// themselves with a margin of two and a half respectively.
///
/// Sides flagged in `rim` count with the whole second differences of their curves, since a rim's
/// outline matters within the surface too.
ChordBound chord_bound(const CellPatch& patch, const LimitPatch& limit, double offset_mm,
                       const std::array<bool, 4>& rim);

}  // namespace limitgauge::engine::surface
