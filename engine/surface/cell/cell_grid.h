#pragma once

#include <array>
#include <vector>

#include "engine/surface/cell/mesh_bound.h"

namespace limitgauge::engine::surface {

/// The cells of a patch at one depth, with what is proven of each.
class CellGrid {
 public:
  /// `rim` tells the sides at which the surface ends or is sharp.
  CellGrid(const CellPatch& patch, double offset_mm, const std::array<bool, 4>& rim);

  int cells() const { return m_; }
  /// Whether cell (u, v) is one of the `width`² at an extraordinary corner.
  bool at_extraordinary(int u, int v, int width) const;
  /// Of cell (u, v) with its neighbours.
  MeshBound bound(int u, int v) const;
  /// Whether the block of cell (u, v) touches a smooth side.
  bool meets(int u, int v) const;
  /// How far at most piece `t` of `side` lies from its chord, along and across the surface, mm.
  SplitBound side_bound(int side, int t) const;
  /// Of all pieces but those of the `width` cells at extraordinary corners.
  SplitBound side_bound_but(int side, int width) const;

 private:
  const DerivativeBounds& at(int u, int v) const { return cells_[v * m_ + u]; }
  std::array<int, 2> on_side(int side, int t) const;

  int m_;
  std::array<bool, 4> rim_;
  std::array<bool, 4> extraordinary_{};
  std::vector<DerivativeBounds> cells_;
};

}  // namespace limitgauge::engine::surface
