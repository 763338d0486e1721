#pragma once

#include <optional>
#include <vector>

#include "simulator/sweep/capsule_batch.h"
#include "simulator/sweep/cube.h"
#include "simulator/sweep/move_batch.h"
#include "simulator/sweep/sweep_index.h"
#include "simulator/sweep/turning/turning_rivals.h"

namespace limitgauge::simulator {

/// The moves of one pass that can be nearest somewhere in a cube. Cubes and places are in the frame
/// that the pass is asked in; the moves are held in the pass's own.
class NearMoves {
 public:
  /// Out of all moves of the pass; more than kMostHandedDown are not held. None where the nearest
  /// one's distance at the cube's middle is not below `limit`. Gives that distance, infinity for
  /// none.
  double gather(const SweepIndex& pass, const Cube& cube, double limit);
  /// Out of `wider`, those of a cube that holds this one; otherwise likewise.
  double narrow(const SweepIndex& pass, const NearMoves& wider, const Cube& cube, double limit);

  /// The one nearest to a place in the cube, if its distance is below `bound`.
  std::optional<NearestMove> nearest(const SweepIndex& pass, const model::Vec3& p,
                                     double bound) const;
  bool empty() const { return moves_.size() == 0 && !too_many_; }

 private:
  // All of these in the pass's own frame.
  double gather_own(const SweepTree& pass, const HeldCube& cube, double limit);
  std::optional<NearestMove> nearest_own(const SweepTree& pass, const model::Vec3& p,
                                         double bound) const;
  // Into kept_, where the nearest one's distance at the middle, which they give, is within the
  // limit.
  double keep_balls(const SweepTree& pass, const MoveBatch& from, const HeldCube& cube,
                    double limit);
  double keep_others(const SweepTree& pass, const MoveBatch& from, const HeldCube& cube,
                     double limit);
  // Into samples_; gives the least distance.
  double sample(const SweepTree& pass, const MoveBatch& from, const HeldCube& cube, double limit);
  std::size_t straightest(const SweepTree& pass, const MoveBatch& from, const HeldCube& cube,
                          double& bend) const;

  MoveBatch moves_;
  bool too_many_ = false;    // to be held: those of the whole pass are asked
  bool below_tops_ = false;  // all of the cube is, of balls
  CapsuleNarrowing capsules_;
  TurningRivals rivals_;
  BatchSamples samples_;
  mutable std::vector<double> squares_;
  mutable std::optional<std::uint32_t> last_;  // that was nearest: one of moves_
  std::vector<std::uint32_t> kept_;
};

}  // namespace limitgauge::simulator
