#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "simulator/sweep/move_batch.h"

namespace limitgauge::simulator {

/// What the inner loops read of the feet of moves.
struct FeetColumns {
  const double *squared, *x, *y, *z, *slide, *turn;
};

/// Which ball moves of a batch can be nearest in a cube, and how near the nearest is to its middle.
/// Valid where the tops do not matter.
///
/// A ball's move is the set S of places at or above the way of its centre, grown by the radius:
/// what counts is the squared distance D² to S. With q from the foot to the middle of the cube, and
/// δ from there to a place of the cube of half edge h,
///   D_i²(δ) >= D_i² + 2 q_i·δ + |δ|² − m_i(δ),   D_j²(δ) <= D_j² + 2 q_j·δ + |δ|² − n_j(δ).
/// m is what a foot gains by sliding along S. With u the direction of the move it is at most
/// max(0, h|u|₁ − |u·q|)² and (u·δ)² where the foot stays on the way, which is so for
/// q_z <= −(1 + √3) h, and at most |δ|² always. n is (u_j·δ)² where the foot can slide that far
/// both ways, and at least 0. Of two moves in nearly the same direction m and n are nearly the
/// same; what remains is linear in δ, so that i loses against j all over the cube where
///   D_i² − D_j² > 2h |q_i − q_j|₁ + max(m_i − n_j).
class CapsuleNarrowing {
 public:
  /// The least squared distance at `p`, the middle of a cube. `batch` must not be empty.
  double nearest(const MoveBatch& batch, const model::Vec3& p, double half_edge_mm);
  /// Puts the places of those that can be nearest somewhere in that cube into `kept`: all but those
  /// that lose against the nearest at the middle, or against the nearest at a corner.
  void keep(const MoveBatch& batch, std::vector<std::uint32_t>& kept);

 private:
  /// Of each move: D², q, the bound of m, and by how much m and n may differ from those of the
  /// direction of the nearest move.
  struct Feet {
    std::vector<double> squared, x, y, z, slide, turn;
    void resize(std::size_t n);
    FeetColumns columns() const;
  };
  /// A move that others are held against.
  struct Rival {
    double squared, x, y, z, turn;
  };
  Rival rival(const MoveBatch& batch, std::uint32_t place, const Feet& feet, std::size_t at) const;
  void lose_at_corners(const MoveBatch& batch, const std::vector<std::uint32_t>& kept);
  void take_kept(const std::vector<std::uint32_t>& kept);

  model::Vec3 p_;
  double half_edge_ = 0, least_ = 0;
  Feet all_, some_;
  std::vector<double> margin_, tangent_;
};

/// Voxels along an edge of the cubes that are worked out at once.
inline constexpr int kCubeEdge = 4;
using CubeDistances = std::array<double, kCubeEdge * kCubeEdge * kCubeEdge>;

/// Coordinates of the voxels of a cube along each axis.
struct CubeAxes {
  std::array<double, kCubeEdge> x, y, z;
};
/// Least distance of those ball moves of a batch that `places` names at the voxels of a cube, x
/// before y, z slowest; valid where the tops do not matter.
CubeDistances least_ball_distances(const MoveBatch& batch, std::span<const std::uint32_t> places,
                                   double radius_mm, const CubeAxes& axes);

}  // namespace limitgauge::simulator
