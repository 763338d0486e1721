#pragma once

#include <vector>

#include "engine/surface/cell/cell_grid.h"
#include "engine/surface/level_map.h"

namespace limitgauge::engine::surface {

/// Bounds on the distance of limit surface and limit mesh about a corner, mm.
struct ZoneBound {
  double surface = 0;  ///< between surface and mesh
  SplitBound side;     ///< between the patch's sides and their chords
  Meeting meeting;     ///< at smooth sides, but for Q
};

/// Bounds for the limit mesh at an extraordinary corner of a patch, where the surface is no
/// polynomial: over the five cells each way at the corner, and for meshes finer than analysed
/// elsewhere over the rings of cells between.
///
/// The argument is that of mesh_bound.h for each cell Q with the block D of its neighbours two
/// cells each way, with these changes. E_n, E_t, ω and σ come from pieces: three cells a level on
/// which the surface is bicubic (the deviation at their nodes, which is exact, plus their own
/// interpolation bound, and their Bézier points), and the convex hull of the control points for the
/// speck that is left. Slope, orientation and one-to-one of the mesh come from its own edges in D,
/// all pairs of them; those of the surface are not needed: from surface to mesh, let f(p) overhang
/// no line through a chord of a rim in D by more than ω. Moved by ω c along the middle of the
/// inward directions (c the inverse of the least cosine with them) it is inside all of them, so in
/// P L(D), since a way out of P L(D) leads across one of these lines or farther than `reach`, twice
/// det_min / max(|a|, |b|). From mesh to surface, homotopy and arcs are as there, so
///   E_n + τ (E_t + |T| x) + x, x = max(ω c, 2σ) at rims,  where E_t + |T| ω c < reach.
/// E_t, reach and τ are measured after the linear map T of the level plane that takes the mean
/// edges to unit vectors, since cells at such corners may grow ever thinner. Beyond smooth sides
/// points slide onto the meshes of other patches. These are taken to rise no more steeply than this
/// one, so τ E_t counts twice: the one step that is not proven here, since a patch knows nothing of
/// its neighbours' depths.
class VertexZones {
 public:
  /// Cells each way that are bounded, and that are looked at for it.
  static constexpr int kWidth = 5, kBlock = 8;

  /// `corner` is the cell at the corner of a patch of depth `level`, as a patch of its own.
  /// Of its sides 0 and 3, `rim` tells those at which the surface ends or is sharp.
  VertexZones(CellPatch corner, int level, int analysed_depth, int largest_depth,
              const std::array<bool, 4>& rim);

  /// For the mesh of a depth; infinite for the first depths.
  ZoneBound at(int depth) const;

 private:
  /// A cell on which the surface is bicubic.
  struct Piece {
    ControlCell net;
    std::array<Vec3, 16> bezier;
  };
  /// The cells at the corner at one depth.
  struct Level {
    std::array<Vec3, (kBlock + 1) * (kBlock + 1)> nodes;  ///< limit points, row by row
    std::array<Piece, kBlock * kBlock> pieces;            ///< the first stands for nothing
    std::vector<Vec3> hull;                               ///< control points of the first cell
    const Vec3& node(int u, int v) const { return nodes[v * (kBlock + 1) + u]; }
    const Piece& piece(int u, int v) const { return pieces[v * kBlock + u]; }
  };
  struct Ring {
    std::vector<MeshBound> cells, meeting;
    SplitBound side;
  };
  class Zone;

  void add_level(const CellPatch& patch, int width);
  void add_ring(const CellPatch& patch);
  ZoneBound rings_at(int depth) const;
  ZoneBound zone(std::size_t at) const;

  int first_ = 0, analysed_ = 0;
  std::array<bool, 4> rim_{};
  std::vector<Level> levels_;     ///< from depth first_
  std::vector<Ring> rings_;       ///< from depth analysed_ + 1
  std::vector<ZoneBound> zones_;  ///< from depth first_
};

}  // namespace limitgauge::engine::surface
