#pragma once

#include <array>
#include <vector>

#include "engine/surface/mesh_bound.h"

namespace limitgauge::engine::surface {

/// The cells of a patch at one depth, with what is proven of each.
class CellGrid {
 public:
  CellGrid(const CellPatch& patch, double offset_mm);

  int cells() const { return m_; }
  /// Whether cell (u, v) is one of the `width`² at an extraordinary corner.
  bool at_extraordinary(int u, int v, int width) const;
  /// Of cell (u, v) with its neighbours.
  MeshBound bound(int u, int v) const;
  /// How far at most piece `t` of `side` lies from its chord, mm.
  double side_bound(int side, int t) const;
  /// Of all pieces but those of the `width` cells at extraordinary corners.
  double side_bound_but(int side, int width) const;

 private:
  const DerivativeBounds& at(int u, int v) const { return cells_[v * m_ + u]; }
  std::array<int, 2> on_side(int side, int t) const;

  int m_;
  std::array<bool, 4> extraordinary_{};
  std::vector<DerivativeBounds> cells_;
};

}  // namespace limitgauge::engine::surface
