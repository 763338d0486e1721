#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "simulator/sweep/move_batch.h"

namespace limitgauge::simulator {

/// Which moves of a batch that turn their tool can be nearest somewhere in a cube. Each is held
/// against some that are: at the middle, and by the planes at the corners. As it stands at the time
/// of its sample such a rival is a convex body, so that its distance less a plane is greatest at a
/// corner, edges of the cutter or not. Proof: simulator/PROOFS.md, P12.
class TurningRivals {
 public:
  /// Puts the places of those that can be into `kept`; `samples` are the batch's at the middle of
  /// a cube of that half edge, their sags for its half diagonal.
  void keep(const SweepTree& pass, const MoveBatch& moves, const BatchSamples& samples,
            const model::Vec3& middle, double half_edge_mm, double half_diagonal_mm,
            std::vector<std::uint32_t>& kept);

 private:
  using Corners = std::array<double, 8>;
  void drop(const BatchSamples& samples, const Corners& rival, std::uint32_t own,
            std::vector<std::uint32_t>& kept) const;
  std::uint32_t lowest_at(const BatchSamples& samples, std::size_t corner,
                          std::span<const std::uint32_t> kept) const;
  Corners rival(const SweepTree& pass, const MoveBatch& moves, const BatchSamples& samples,
                std::uint32_t place) const;

  model::Vec3 middle_;
  double half_diagonal_ = 0;
  std::array<model::Vec3, 8> corners_;  // from the middle
};

}  // namespace limitgauge::simulator
