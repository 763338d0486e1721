#pragma once

#include <limits>
#include <span>

#include "engine/surface/cell/cell_bounds.h"

namespace limitgauge::engine::surface {

/// How the mesh of a patch meets those beyond its smooth sides.
struct Meeting {
  double bulge_mm = 0;  ///< by how much surface or mesh reach over what lies beyond
  double slope = 0;     ///< of the mesh and of the surface, seen from m; infinite where not proven
  double width_mm =
      std::numeric_limits<double>::infinity();  ///< to which the block goes on at least
};
/// The worse of both.
Meeting worse(const Meeting& a, const Meeting& b);

/// A bound on the distance, either way and in mm, between a map f over a cell and the mesh that has
/// its nodes on f, for any number of halvings of the cell: the lesser of `plain` (B3) and, where it
/// holds, `sliding` (B7). Sides beyond which another patch goes on smoothly are left out of
/// `sliding` and told by `meeting`. Proofs: engine/surface/BOUNDS.md.
class MeshBound {
 public:
  /// The block of `cell` and all its neighbours within the patch, itself among them; `bend` is the
  /// largest side_bend of the block's cells along the patch's sides, seen from the cell's normal:
  /// of rims, where the surface ends or is sharp, and of other sides.
  struct Bend {
    double rim = 0, smooth = 0;
  };
  MeshBound(const DerivativeBounds& cell, std::span<const DerivativeBounds* const> block,
            const Bend& bend);
  /// Bounds with cells of `scale` times the area.
  double at(double scale) const;
  Meeting meeting(double scale) const;

 private:
  bool slides(double scale) const { return 2 * slide_ * scale < reach_; }

  double plain_ = 0, sliding_ = 0, reach_ = 0, slide_ = 0;
  Meeting meeting_;
};

/// Bound on the second derivative of the line of `cell` in u (or v), across a chord of any piece of
/// it and seen along `normal`, for all shares of the offset.
double side_bend(const DerivativeBounds& cell, bool in_u, const Vec3& normal);

}  // namespace limitgauge::engine::surface
