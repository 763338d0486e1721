#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "engine/surface/cell_patch.h"

namespace limitgauge::engine::surface {

/// Bounds on the distance, either way, between a patch and its triangulated limit mesh (each cell
/// split along its first diagonal), mm; infinite where nothing is proven.
struct ChordBound {
  double limit_mm = 0;  ///< of the limit surface, the whole patch
  /// Of the surface moved out along its normals by up to the offset asked for, but for the places
  /// about extraordinary corners: see ChordBounds::corner_depth.
  double offset_mm = 0;
  /// How far at most a piece of each side lies from its chord, limit and offset, the latter but for
  /// the same places: by so much a finer neighbour moves that is laid onto this mesh.
  std::array<double, 4> side_mm{};
  double largest_mm() const { return std::max(limit_mm, offset_mm); }
};

struct ChordBounds {
  std::vector<ChordBound> at;  ///< by depth, 0 to the largest asked for
  /// The offset is bounded over all but the cells of this depth at extraordinary corners, where
  /// normals may turn ever faster.
  int corner_depth = 0;
  std::array<bool, 4> extraordinary{};
};

/// What bounds are asked for.
struct BoundRequest {
  double offset_mm = 0;
  int analysed_depth = 5;  ///< to which control nets are looked at
  int largest_depth = 10;
  bool limit = true;  ///< the limit mesh at extraordinary corners too
};

/// Proven bounds for all depths up to the largest, rounding aside, from the control net of `patch`
/// (of any depth) down to the depth to be analysed: see cell_bounds.h and mesh_bound.h for
/// cells on which the surface is bicubic, vertex_zone.h for those at extraordinary corners. Past
/// that depth bounds fall by four a level.
ChordBounds chord_bounds(CellPatch patch, const BoundRequest& request);

}  // namespace limitgauge::engine::surface
