#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "simulator/sweep/cube.h"
#include "simulator/sweep/sweep_tree.h"

namespace limitgauge::simulator {

/// What a pass sweeps, asked in the frame of the stock that it is cut into. Its moves stand in the
/// frame of its own path, where the cutter is upright; a place is brought there, and what is found
/// is brought back. A pass of the setup at work lies as it is asked, and costs nothing more.
///
/// Proof of what is said of turned cubes: simulator/PROOFS.md, P7.
class SweepIndex {
 public:
  /// Throws as SweepTree does.
  explicit SweepIndex(const Pass& pass, const model::RunControl& control = {});

  /// As SweepTree::nearest, at a place of the stock's frame and with the gradient in it.
  std::optional<NearestMove> nearest(
      const model::Vec3& p, double bound,
      std::uint32_t end = std::numeric_limits<std::uint32_t>::max()) const;
  /// As SweepTree::gather.
  void gather(const model::Vec3& p, double limit, std::vector<std::uint32_t>& slots) const {
    own_.gather(to_own(p), limit, slots);
  }
  SweptSample distance(std::uint32_t slot, const model::Vec3& p) const {
    return from_own(own_.distance(slot, to_own(p)));
  }
  /// As SweepTree::sag and convex_part.
  double sag(std::uint32_t slot, const model::Vec3& p, const SweptSample& at, double reach) const {
    return own_.turns() ? own_.sag(slot, to_own(p), at, reach) : 0.0;
  }
  SweptSample convex_part(std::uint32_t slot, const SweptSample& at, const model::Vec3& p) const {
    return from_own(own_.convex_part(slot, at, to_own(p)));
  }
  /// As simulator::outside_bound for one move, where `at` is distance(slot, p).
  double outside_bound(std::uint32_t slot, const model::Vec3& p, const SweptSample& at,
                       const model::Vec3& half) const;

  /// The moves in the frame of the path, and the way there and back.
  const SweepTree& own() const { return own_; }
  bool turned() const { return turned_; }
  const model::Pose& pose() const { return pose_; }  ///< the path's frame to the stock's
  model::Vec3 to_own(const model::Vec3& p) const { return turned_ ? pose_.point_back(p) : p; }
  /// The half edge stays where the pose keeps axes, and grows by up to √3 elsewhere.
  HeldCube to_own(const Cube& cube) const {
    return {to_own(cube.middle), cube.half_edge_mm * widening_, cube.half_diagonal()};
  }
  /// The same distance with its gradient in the stock's frame.
  SweptSample from_own(SweptSample at) const {
    if (turned_) at.gradient = pose_.direction(at.gradient);
    return at;
  }

  std::size_t size() const { return own_.size(); }
  std::size_t memory_bytes() const { return own_.memory_bytes(); }

 private:
  SweepTree own_;
  model::Pose pose_, inverse_;
  bool turned_ = false;
  double widening_ = 1;
};

}  // namespace limitgauge::simulator
