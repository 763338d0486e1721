#include "simulator/grid/pass_lattice.h"

#include <cmath>

namespace limitgauge::simulator {

using model::Pose;
using model::Vec3;

PassLattice::PassLattice(const Lattice& lattice, const SweepIndex& pass)
    : pass_(pass), lattice_(lattice), straight_(pass.pose().keeps_axes()) {
  if (!pass.turned()) return;
  const Pose to_own = pass.pose().inverse();
  if (straight_) {
    rename(to_own);
  } else {
    widening_ = to_own.widening();
    height_ = to_own.half({1, 1, 1}).z;
  }
}

// A product of turns that keeps axes may have 1e-16 where there would be 0: the axis is that of the
// component that is 1. Along an axis that runs the other way, voxel i is voxel −1 − i here: cubes
// whose corners are multiples of their edge stay such cubes.
void PassLattice::rename(const Pose& to_own) {
  renamed_ = true;
  lattice_.origin_mm = to_own.point(lattice_.origin_mm);
  for (int a = 0; a < 3; ++a) {
    for (int b = 0; b < 3; ++b)
      if (std::abs(to_own.rows[a][b]) > 0.5) from_[a] = b, back_[a] = to_own.rows[a][b] < 0;
    if (back_[a]) lattice_.origin_mm[a] += lattice_.voxel_mm;
  }
}

Index3 PassLattice::own_corner(const Index3& corner, int edge) const {
  Index3 own{};
  for (int a = 0; a < 3; ++a) own[a] = back_[a] ? -corner[from_[a]] - edge : corner[from_[a]];
  return own;
}

Index3 PassLattice::asked_corner(const Index3& corner, int edge) const {
  Index3 asked{};
  for (int a = 0; a < 3; ++a) asked[from_[a]] = back_[a] ? -corner[a] - edge : corner[a];
  return asked;
}

Index3 PassLattice::own_in_cube(const Index3& voxel, int edge) const {
  Index3 own{};
  for (int a = 0; a < 3; ++a) own[a] = back_[a] ? edge - 1 - voxel[from_[a]] : voxel[from_[a]];
  return own;
}

double PassLattice::top_mm(const Index3& corner, int edge) const {
  if (straight_) return lattice_.point({corner[0], corner[1], corner[2] + edge - 1}).z;
  return middle(corner, edge).z + lattice_.half_edge(edge) * height_;
}

}  // namespace limitgauge::simulator
