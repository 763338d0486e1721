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
/// Statement, proof and the one step that is not proven: engine/surface/BOUNDS.md, B8.
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
