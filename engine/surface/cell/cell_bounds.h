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

/// Bounds for the limit surface over `cell` (engine/surface/BOUNDS.md, B1).
DerivativeBounds limit_bounds(const ControlCell& cell);

/// Bounds for S + r n with unit normal n, 0 <= r <= offset_mm (engine/surface/BOUNDS.md, B2). Not
/// proven where the normal's length has no positive bound over the cell.
DerivativeBounds offset_bounds(const ControlCell& cell, double offset_mm);

}  // namespace limitgauge::engine::surface
