#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "simulator/grid/lattice.h"
#include "simulator/grid/pass_lattice.h"
#include "simulator/sweep/capsule_batch.h"
#include "simulator/sweep/capsule_leaf.h"
#include "simulator/sweep/move_batch.h"
#include "simulator/sweep/sweep_index.h"
#include "simulator/sweep/turning/turning_rivals.h"

namespace limitgauge::simulator {

inline constexpr int kLeafEdge = 8;
/// Edge of the blocks that are cut independently of each other, in voxels.
inline constexpr int kBlockEdge = 32;

/// min_i d_i at the voxels of a leaf, clamped to ±band, z fastest.
using LeafDistances = std::array<float, kLeafEdge * kLeafEdge * kLeafEdge>;

/// Receives what a pass does to the blocks, leaf by leaf in a fixed order.
class LeafSink {
 public:
  virtual ~LeafSink() = default;
  /// False where nothing stands in the cube, so that it need not be worked out.
  virtual bool wanted(const Index3& corner, int edge) const = 0;
  /// All voxels of the cube are deeper than the band inside the swept space.
  virtual void removed(const Index3& corner, int edge) = 0;
  virtual void reached(const Index3& corner, const LeafDistances& distances) = 0;
};

/// Works out min_i d_i block by block. Candidate moves are handed down from block to sub-block:
/// d_i is convex and 1-Lipschitz, and the nearest move's d_j lies below a paraboloid about the
/// middle, so move i cannot matter in a block of half edge h and half diagonal r where
/// d_i − d_j > min(2r, h·|g_i − g_j|₁ + e_j); of tools that turn TurningRivals tells. All of it
/// goes on in the frame of the pass's own path (PassLattice), where a leaning cube has the h of the
/// cube along the axes that holds it.
class BlockCutter {
 public:
  enum class Reach { none, partly, wholly };

  BlockCutter(const SweepIndex& pass, const Lattice& lattice, double band_mm);

  /// Does the pass reach into a cube, or swallow it whole with its band? `least` is the distance at
  /// its middle, `reach` half its diagonal and the band.
  static Reach reach_of(double least, double reach);
  /// `nearest` is the move nearest to the block's middle, where it is known, in the path's frame.
  void cut(const Index3& corner, LeafSink& sink,
           const std::optional<NearestMove>& nearest = std::nullopt);

 private:
  struct Level {
    MoveBatch moves;
    BatchSamples samples;
    std::vector<std::uint32_t> kept;
  };
  std::optional<NearestMove> nearest(const Index3& corner, int edge) const;
  void cut_cube(int depth, const Index3& corner, int edge, const NearestMove& nearest,
                LeafSink& sink);
  void gather(const NearestMove& nearest, const Index3& corner, int edge);
  Reach narrow(Level& level, const Index3& corner, int edge);
  void sample(Level& level, const model::Vec3& p, double half_diagonal) const;
  void keep_that_matter(Level& level, const model::Vec3& middle, int edge);
  std::size_t reference_move(const Level& level, const model::Vec3& middle, double reach,
                             double& bound) const;
  void descend(int depth, const Index3& corner, int edge, LeafSink& sink);
  void fill_leaf(int depth, const Index3& corner);
  bool fill_leaf_at_once(const Level& level, const Index3& corner);
  void fill(int depth, const Index3& corner, int edge);
  Reach narrow_balls(Level& level, const Index3& corner, int edge);
  bool worth_no_split(const Level& level, const Index3& corner, int edge) const;
  void fill_with_balls(const Level& level, const Index3& corner);
  void fill_voxels(int depth, const Index3& corner);
  void fill_turning_voxels(const Level& level, const Index3& corner);
  void set_cube(const Index3& corner, int edge, float value);
  float& leaf_at(const Index3& i);
  bool balls_below_tops(const MoveBatch& moves, double highest) const;

  const SweepTree& pass_;
  PassLattice lattice_;
  double band_;
  std::vector<Level> levels_;  // one for each halving of a block
  std::vector<std::uint32_t> slots_;
  CapsuleNarrowing capsules_;
  CapsuleLeaf capsule_leaf_;
  TurningRivals rivals_;
  std::vector<std::pair<double, std::uint32_t>> planes_;  // of slots at one voxel
  LeafDistances leaf_{};
};

}  // namespace limitgauge::simulator
