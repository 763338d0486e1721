#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "engine/surface/cell/vertex_zone.h"

namespace limitgauge::engine::surface {

/// Bounds on the distance, either way, between a surface and its triangulated mesh (each cell split
/// along its first diagonal); infinite where nothing is proven.
struct MeshError {
  double own_mm = 0;          ///< within the patch, but for extraordinary corners
  double corner_mm = 0;       ///< about extraordinary corners (limit mesh only)
  double corner_side_mm = 0;  ///< there: how far sides lie from their chords, as seen off the mesh
  Meeting meeting;            ///< with other patches across smooth sides
  /// How far at most a piece of each side lies from its chord, along and across the normal, mm: so
  /// much a side moves that is laid onto the chords of a coarser neighbour.
  std::array<SplitBound, 4> sides{};
};

/// What is proven of a patch at one depth.
struct ChordBound {
  MeshError limit;  ///< limit surface and limit mesh
  /// Of the surface moved out along its normals by up to the offset asked for, but for the places
  /// about extraordinary corners: see ChordBounds::corner_depth.
  MeshError offset;
  /// Of both meshes but for extraordinary corners.
  double largest_mm() const { return std::max(limit.own_mm, offset.own_mm); }
};

struct ChordBounds {
  std::vector<ChordBound> at;  ///< by depth, 0 to the largest asked for or the one that is enough
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
  bool limit = true;          ///< the limit mesh at extraordinary corners too
  std::array<bool, 4> rim{};  ///< sides at which the surface ends or is sharp
  /// Where no limit mesh at an extraordinary corner is bounded, the patch is looked at no deeper
  /// than to the first depth, from `least_depth` on, at which both meshes keep within this: every
  /// depth has four times the cells of the one before.
  double enough_mm = kNeverEnough;
  int least_depth = 0;
  static constexpr double kNeverEnough = -1;
};

/// Bounds for all depths up to the largest, rounding aside, from the control net of `patch` (of any
/// depth) down to the depth to be analysed: by B3 to B7 of engine/surface/BOUNDS.md for cells on
/// which the surface is bicubic, by B8 for those at extraordinary corners. Past that depth bounds
/// fall by four a level.
ChordBounds chord_bounds(CellPatch patch, const BoundRequest& request);
/// Adds the bounds of the next depth to those of the same patch that end at what was enough: what
/// chord_bounds gives where nothing is.
void add_next_depth(ChordBounds& bounds, CellPatch patch, const BoundRequest& request);

}  // namespace limitgauge::engine::surface
