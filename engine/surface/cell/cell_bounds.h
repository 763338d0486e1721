#pragma once

#include <array>

#include "engine/surface/cell/control_cell.h"
#include "engine/surface/level_map.h"

namespace limitgauge::engine::surface {

/// Bounds on a vector seen from a direction: its part along it, its length across it, and that
/// length after a linear map of the level plane.
struct SplitBound {
  double along = 0, across = 0, mapped = 0;
};

/// What is proven of a twice differentiable map f over one cell of unit sides: its first
/// derivatives at the middle, and bounds on the second ones over the whole cell, seen from the
/// unit normal at the middle; the map takes the first derivatives of the limit surface at the
/// middle to unit vectors, so that long and thin cells look like others. Lengths in mm.
struct DerivativeBounds {
  bool proven = false;  ///< false: no bound was found, the rest stands for nothing
  Vec3 normal;
  Vec3 du, dv;              ///< of the limit surface
  Vec3 du_moved, dv_moved;  ///< of the surface moved out all the way
  LevelMap map;
  SplitBound duu, duv, dvv;
  /// Bounds on the part of d²f/du² across both the normal and df/du, and the same in v: how much
  /// the lines of the grid bend within the surface.
  double bend_u = 0, bend_v = 0;
};

/// Bounds for the limit surface over `cell`: the second derivatives lie in the hull of the second
/// differences of the control net, the third derivatives in that of the third.
DerivativeBounds limit_bounds(const ControlCell& cell);

/// Bounds for S + r n with unit normal n, 0 <= r <= offset_mm. With N = S_u × S_v,
///   n_u = P N_u / |N|   and   n_uu = P N_uu / |N| - 2 (n·N_u) P N_u / |N|² - n |n_u|²,
/// P the projection across n, and likewise for uv and vv. Of a product a × b only the parts
/// a·n and b·n can turn out across n, so P N_u and P N_uu are bounded by the parts of the second
/// and third derivatives of S along n: flat surfaces with uneven parameters cost nothing. |N| is
/// bounded below through S_u and S_v at the middle and their change over the cell; where that
/// bound is not positive nothing is proven.
DerivativeBounds offset_bounds(const ControlCell& cell, double offset_mm);

}  // namespace limitgauge::engine::surface
