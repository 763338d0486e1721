#pragma once

#include <array>
#include <optional>

#include "engine/surface/cell/cell_patch.h"

namespace limitgauge::engine::surface {

/// The 4 × 4 control points of a cell on which the limit surface is one uniform bicubic.
struct ControlCell {
  std::array<Vec3, 16>
      points;  ///< row by row, from (-1, -1) to (2, 2) about the cell's first corner
  const Vec3& at(int i, int j) const { return points[j * 4 + i]; }
  /// The 16 Bézier points of the cell, row by row: their hull holds the surface.
  std::array<Vec3, 16> bezier() const;
};

/// Differences of the control points, `times_u` in u and `times_v` in v: the hull of them holds the
/// derivative of that order over the cell, mm over its unit sides.
class Differences {
 public:
  Differences(const ControlCell& cell, int times_u, int times_v);
  template <class Visit>
  void for_each(const Visit& visit) const {
    for (int j = 0; j < rows_; ++j)
      for (int i = 0; i < columns_; ++i) visit(value_[j * 4 + i]);
  }

 private:
  std::array<Vec3, 16> value_;
  int columns_ = 4, rows_ = 4;
};

/// The control points of cell (u, v) of a patch of depth 1 or more without semi-sharp tags; across
/// a boundary or crease the net is its own reflection (engine/surface/BOUNDS.md, B1). None at an
/// extraordinary corner.
std::optional<ControlCell> control_cell(const CellPatch& patch, int u, int v);

}  // namespace limitgauge::engine::surface
