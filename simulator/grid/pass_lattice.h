#pragma once

#include "simulator/grid/lattice.h"
#include "simulator/sweep/sweep_index.h"

namespace limitgauge::simulator {

/// The voxels of a level set as a pass has them in the frame of its own path.
///
/// Where the pose turns by right angles alone, they are a lattice along the axes there too: cubes
/// and leaves have other corners and another order, and everything that needs straight rows works
/// as it is. Elsewhere the voxels keep their indices and their cubes lean: of a cube there is then
/// its middle, the half edge of a cube along the axes that holds it, and its own half diagonal,
/// which is that of the ball about it however it lies.
class PassLattice {
 public:
  PassLattice(const Lattice& lattice, const SweepIndex& pass);

  /// Do rows of voxels lie along the axes of the path's frame?
  bool straight() const { return straight_; }
  /// Are the indices here others than those of the level set?
  bool renamed() const { return renamed_; }

  /// The lowest corner here of a cube of the level set, and the other way round.
  Index3 own_corner(const Index3& corner, int edge) const;
  Index3 asked_corner(const Index3& corner, int edge) const;
  /// The voxel here, in a cube of `edge` voxels, of a voxel of the level set, both counted from the
  /// lowest corner of the cube.
  Index3 own_in_cube(const Index3& voxel, int edge) const;

  model::Vec3 point(const Index3& i) const { return own(lattice_.point(i)); }
  model::Vec3 middle(const Index3& corner, int edge) const {
    return own(lattice_.middle(corner, edge));
  }
  double half_edge(int edge) const { return lattice_.half_edge(edge) * widening_; }
  double half_diagonal(int edge) const { return lattice_.half_diagonal(edge); }
  double voxel_mm() const { return lattice_.voxel_mm; }
  /// No voxel of the cube lies higher, mm in the path's frame.
  double top_mm(const Index3& corner, int edge) const;

 private:
  model::Vec3 own(const model::Vec3& p) const { return straight_ ? p : pass_.to_own(p); }
  void rename(const model::Pose& to_own);

  const SweepIndex& pass_;
  Lattice lattice_;  // of the path's frame where straight
  bool straight_ = true, renamed_ = false;
  Index3 from_{0, 1, 2};                           // the level set's axis of each one here
  std::array<bool, 3> back_{false, false, false};  // that runs the other way
  double widening_ = 1,
         height_ = 1;  // half the extent of a cube, along the widest axis and along z
};

}  // namespace limitgauge::simulator
