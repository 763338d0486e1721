#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "model/base/run_control.h"
#include "simulator/grid/lattice.h"
#include "simulator/grid/volume_sum.h"
#include "simulator/stock/material.h"

namespace limitgauge::simulator {

/// A surface cell where the level set is not linear: at an edge, or along a surface that it does
/// not reach with the same slope from both sides.
struct BentCell {
  std::uint64_t key = 0;  ///< scrambled place: the cells of least key are a sample
  Index3 at{};
  double share = 0;  ///< of it that is inside, as linear interpolation has it
  friend bool operator<(const BentCell& a, const BentCell& b) {
    return a.key != b.key ? a.key < b.key : a.at < b.at;
  }
};

/// All bent cells, counted, with a sample of them that is the same in whatever order and parts
/// they are added.
class BentCells {
 public:
  void add(const Index3& at, double share);
  BentCells& operator+=(const BentCells& b);
  std::uint64_t count() const { return count_; }
  std::vector<BentCell> sample() const;

 private:
  void keep_least();

  std::uint64_t count_ = 0;
  std::vector<BentCell> some_;  // the least ones and others
};

/// The volume of a grid: by linear interpolation, and where that is off.
struct GridVolume {
  VolumeSum linear;
  BentCells bent;

  GridVolume& operator+=(const GridVolume& b) {
    linear += b.linear, bent += b.bent;
    return *this;
  }
  /// In voxels, the bent cells worked out by halving with the exact material; of more than 4096 of
  /// them, those of the sample, for all. A cell is off by some 0.05 of a voxel, so that the sum of
  /// n cells is then off by 0.0008 n voxels: of a cut's volume, far less than 0.1 %.
  double voxels(const Material& material, const Lattice& lattice,
                const model::RunControl& control) const;
};

/// Whether the values at the corners of a cube, in tetrahedra.h's order, are off from the nearest
/// linear ones by more than a small share of its edge.
bool is_bent(const std::array<double, 8>& corner_values, double edge_mm);

}  // namespace limitgauge::simulator
