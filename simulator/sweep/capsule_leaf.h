#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "simulator/sweep/move_batch.h"

namespace limitgauge::simulator {

/// The voxels of a leaf of a level set, by their middle.
struct LeafVoxels {
  static constexpr int kEdge = 8;
  static constexpr std::size_t kCount = std::size_t{kEdge} * kEdge * kEdge;

  model::Vec3 middle;
  double voxel_mm = 0;
  double half_edge_mm() const { return 0.5 * (kEdge - 1) * voxel_mm; }
};

/// A move as seen from a leaf's middle, lengths in voxels: the squared distance to the way of the
/// ball's centre less that of the radius; twice q, from the foot to the middle; the way's
/// direction; q along it; how far the foot may slide to either side.
struct WayFromMiddle {
  float square, x, y, z, ux, uy, uz, along, back, ahead;
};

/// Least distances to ball moves at all voxels of a leaf at once, in single precision: as seen from
/// the leaf's middle, where all that is added up is small. Off by less than
/// kSinglePrecision_voxels.
/// Proof: simulator/PROOFS.md, P6.
class CapsuleLeaf {
 public:
  using Distances = std::array<float, LeafVoxels::kCount>;

  /// Is single precision good enough: are the voxels that small for the ball?
  static bool fine_enough(const LeafVoxels& leaf, double radius_mm);
  /// Takes the moves of a batch that `places` names, for a leaf where their tops do not matter.
  /// False where the foot of one may leave the way of the ball's centre: there is nothing to be
  /// asked then.
  bool take(const MoveBatch& batch, std::span<const std::uint32_t> places, const LeafVoxels& leaf,
            double radius_mm);
  /// At the voxels, z fastest and x slowest, clamped to ±band. No move lies farther from the middle
  /// than the leaf's half diagonal and the band beyond the nearest.
  void distances(double band_mm, Distances& out) const;

 private:
  std::vector<WayFromMiddle> ways_;
  double voxel_ = 0, radius_ = 0;  // mm; voxels
};

}  // namespace limitgauge::simulator
