#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "simulator/sweep/move_batch.h"

namespace limitgauge::simulator {

/// 1 + √3, rounded up: below this many half edges a foot keeps to the way all over a cube.
inline constexpr double kFootStaysOnWay = 2.7321;

/// What the inner loops read of the feet of moves.
struct FeetColumns {
  const double *squared, *x, *y, *z, *slide, *turn;
};

/// Which ball moves of a batch can be nearest in a cube, and how near the nearest is to its middle.
/// Valid where the tops do not matter.
/// Proof: simulator/PROOFS.md, P1.
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

/// The ball move of a batch that is nearest to a point, and how near the way of its centre is.
struct BallFound {
  std::size_t place = 0;
  double squared = 0;  ///< mm²
};
/// Of several equal ones the first. `batch` must not be empty; valid where the tops do not matter.
/// `squares` is room to work in.
BallFound nearest_ball(const MoveBatch& batch, const model::Vec3& p, std::vector<double>& squares);

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
