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

/// A bound on the distance, either way, between a map f over a cell and the mesh that has its
/// nodes on f, for any number of halvings of the cell.
///
/// Let L be the mesh over the block D of cells around cell Q, e = f - L, m a unit vector and P the
/// projection along it. A linear interpolant leaves a function over a triangle of unit legs by at
/// most (D_uu + 2 D_uv + D_vv) / 8 (Filip, Magedson and Markot), so in D |m·e| <= E_n and
/// |P e| <= E_t, with the largest second derivatives along and across m; halving the cells divides
/// both by four. |e| <= hypot(E_n, E_t) =: `plain` bounds the distance.
///
/// It is a poor bound where parameters are uneven: points slide along the mesh. Measure E_t and all
/// else in the level plane after the linear map T that takes f_u and f_v at the middle of Q to unit
/// vectors (those of the limit surface, where f is moved out). Let P f_u and P f_v lie within R_u
/// and R_v of their values at the middle, and det_min > 0 be the least of det(a, b) over these two
/// sets. By the mean value theorem, for any two parameters d = (δu, δv) apart, P f and P L both
/// move by ā δu + b̄ δv with ā, b̄ in the (convex) sets. So both keep orientation, are one to one,
/// move by `reach` = det_min / max(|a|, |b|) at least for a step of one cell, and rise over a level
/// path of length x by at most τ x with τ = (|b| max|m·f_u| + |a| max|m·f_v|) / det_min.
///
/// Surface to mesh: let z = P f(p), p in Q. Its degree under P f over D is 1 or more. If z is in
/// P L(D), say at p', then |P L(p') - P L(p)| <= E_t, so f(p) is within E_n + τ E_t of L(p'). If
/// not, its degree under P L is 0, and one of the loops made of an arc of the border of D under f
/// and its chord under L winds around z. No side within the patch does where reach > 2 E_t. So z
/// lies between an arc and a chord of the patch's own side, no farther from the chord than the arc
/// bulges out across it, σ (in mm) <= (bend of the side) / 8: within E_n + τ (E_t + |T| σ) + σ.
/// Mesh to surface: let z = P L(p). If the straight homotopy from P L to P f on the border of D
/// never meets z, some p' of D has P f(p') = z, and f(p') is within E_n + τ E_t of L(p). If it
/// does, it is at a side of the patch, z lies within σ of its chord, and the arc has a point over
/// the same place of the chord (R_u and R_v are at most half the values at the middle, so an arc
/// never turns back): within E_n + τ (E_t + 2 |T| σ) + 2σ.
/// Together: E_n + τ (E_t + 2 |T| σ) + 2σ =: `sliding`, where 2 E_t < reach.
///
/// Where another patch goes on smoothly beyond the side, what lies beyond the chord lies over its
/// mesh: the last 2σ falls to 2σ times the slope of that mesh seen from m. Such sides are left out
/// of `sliding` and told by `meeting`.
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
