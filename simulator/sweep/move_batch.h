#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "simulator/sweep/sweep_tree.h"
#include "simulator/sweep/vector_loops.h"

namespace limitgauge::simulator {

/// Moves that are handed down from a cube to its parts at most. A thread holds some 400 bytes of
/// each: of a path with a million moves on a hand's breadth that would be more than all the rest of
/// a run. Where more of them meet in a cube, its parts ask the tree of the pass again.
inline constexpr std::size_t kMostHandedDown = std::size_t{1} << 16;

/// What the inner loops read of ball moves.
struct BallColumns {
  const double *x, *y, *z, *along_x, *along_y, *run, *rise, *inverse_run, *inverse_length2;
  const double *inverse_length, *norm1;
};

/// Of a point, seen from the nearest place of the way of a ball's centre: in the way's level
/// direction, across it and upwards, mm. Beside the way's upper side, which the shaft clears, only
/// what is level counts.
struct BallFoot {
  double along = 0, across = 0, up = 0;
  double squared() const { return along * along + across * across + up * up; }
};
/// Of move `i`, without branches: loops over moves take several at once.
inline BallFoot ball_foot(const BallColumns& c, std::size_t i, double px, double py, double pz) {
  const double qx = px - c.x[i], qy = py - c.y[i], qz = pz - c.z[i];
  const double along = qx * c.along_x[i] + qy * c.along_y[i];
  const double across = qy * c.along_x[i] - qx * c.along_y[i];
  const double t_level = unit_clamp(along * c.inverse_run[i]);
  const double t_line = unit_clamp((along * c.run[i] + qz * c.rise[i]) * c.inverse_length2[i]);
  const bool above = qz >= c.rise[i] * t_level;
  const double t = above ? t_level : t_line;
  const double below = qz - t * c.rise[i];
  return {along - t * c.run[i], across, above ? 0.0 : below};
}

/// Moves that may matter in one block, with what the inner loops read laid out in columns.
class MoveBatch {
 public:
  static constexpr std::size_t kPad = 8;
  /// Makes this the moves of `slots`.
  void assign(const SweepTree& pass, const std::vector<std::uint32_t>& slots);
  /// Makes this the moves of `from` named by their places in it.
  void take(const MoveBatch& from, const std::vector<std::uint32_t>& places);
  std::size_t size() const { return slot.size(); }

  BallColumns columns() const;
  /// The columns are filled up to this many moves, with the last one again: whole registers.
  std::size_t padded_size() const { return padded(slot.size()); }
  static constexpr std::size_t padded(std::size_t n) { return (n + kPad - 1) / kPad * kPad; }

  /// Below this height a ball's top does not matter for any move of the batch.
  double below_tops_mm(const CutterProfile& profile) const;

  std::vector<std::uint32_t> slot;
  // Ball moves: the centre's start (the lower end of a vertical move, whose upper end is of no
  // account below the tops), the level direction, run, rise, and inverses of their lengths.
  std::vector<double> x, y, z, along_x, along_y, run, rise, inverse_run, inverse_length2;
  std::vector<double> inverse_length, norm1;  // the latter |u|₁ of the unit vector along the move
  double lowest_tip = 0;

 private:
  void assign_balls(const SweepTree& pass);
};

/// Distances and gradients of a batch at one point, and by how much the planes of these may be
/// above the distances somewhere in a cube about it (SweepTree::sag).
struct BatchSamples {
  std::vector<double> distance, gx, gy, gz;
  std::vector<double> sag, t;  // of moves that turn their tool
  void resize(std::size_t n);
  model::Vec3 gradient(std::size_t i) const { return {gx[i], gy[i], gz[i]}; }
  /// `reach` is how far the planes are to hold; a sample that is infinitely far has none.
  void set(std::size_t i, const SweptSample& s, const SweepTree& pass, std::uint32_t slot,
           const model::Vec3& p, double reach);
};

/// Samples of all moves of a batch of ball moves, valid where the tops do not matter.
void sample_balls(const MoveBatch& batch, double radius, const model::Vec3& p, BatchSamples& out);
/// Least distance of a batch of ball moves at eight points.
std::array<double, 8> least_ball_distances(const MoveBatch& batch, double radius,
                                           const std::array<model::Vec3, 8>& points);

}  // namespace limitgauge::simulator
