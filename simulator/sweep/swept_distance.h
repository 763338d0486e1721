#pragma once

#include <cmath>
#include <cstdint>

#include "model/geometry/vec3.h"
#include "simulator/sweep/cutter_profile.h"

namespace limitgauge::simulator {

/// Signed distance to a swept cutter at a point, and where along the move it is attained.
struct SweptSample {
  double distance = 0;   ///< mm, negative inside
  model::Vec3 gradient;  ///< a subgradient: distance(q) >= distance + gradient·(q − p)
  double t = 0;          ///< position along the move, 0 at its start and 1 at its end
  /// Of a move that turns its tool: how far below the distance the plane of the gradient is at p
  /// that is to be under it (turning_sag). Else the plane goes through it.
  double slack_mm = 0;
};

/// A straight move of a cutter's tip with what the distance needs, worked out once.
struct SweptMove {
  SweptMove() = default;
  SweptMove(const model::Vec3& from, const model::Vec3& to, std::uint32_t index_in_path);

  model::Vec3 start, delta;         ///< mm
  double run = 0;                   ///< level length, mm
  double along_x = 1, along_y = 0;  ///< level direction, a unit vector
  double inverse_length2 = 0;       ///< 1 / |delta|², 0 for a move of no length
  double inverse_run2 = 0;          ///< 1 / run², 0 for a vertical move
  std::uint32_t index = 0;          ///< in the path

  bool level() const { return delta.z == 0; }
  bool vertical() const { return run == 0; }
};

/// Of the tip's way.
inline model::Box3 tip_box(const SweptMove& move) {
  model::Box3 box;
  box.add(move.start);
  box.add(move.start + move.delta);
  return box;
}

/// |v|₁ = |x| + |y| + |z|: v·δ is at most h times that where all |δ_a| <= h.
inline double norm1(const model::Vec3& v) {
  return std::abs(v.x) + std::abs(v.y) + std::abs(v.z);
}

/// f(p) = least signed distance from p to the fluted part over all positions along the move.
/// Outside the swept space that is the exact distance to it; inside it is minus the depth in the
/// cutter where that is deepest. f is convex in p and 1-Lipschitz. Closed forms for ball cutters
/// below the flutes' top, for level moves and for vertical moves of a flat; otherwise a safeguarded
/// convex minimisation along the move, to 1e-10 mm.
SweptSample swept_distance(const CutterProfile& profile, const SweptMove& move,
                           const model::Vec3& p);

/// True where a quick look shows that f(p) is not below `bound`. False says nothing.
inline bool cannot_be_below(const CutterProfile& profile, const SweptMove& m, const model::Vec3& p,
                            double bound) {
  if (m.start.z + std::min(0.0, m.delta.z) - p.z >= bound) return true;  // the tip stays above
  const double reach = bound + profile.corner_radius();
  if (reach <= 0) return profile.is_ball();
  // Distance to the line of the corner's centres: only a ball's corner has a single one.
  const double qx = p.x - m.start.x, qy = p.y - m.start.y;
  const double along = qx * m.along_x + qy * m.along_y, across = qy * m.along_x - qx * m.along_y;
  const double wide = profile.largest_radius() + bound;
  const double over = std::max(along - m.run, -along);
  if (wide > 0 && (across * across >= wide * wide || over >= wide)) return true;
  if (!profile.is_ball() || m.vertical()) return false;
  const double qz = p.z - m.start.z - profile.corner_radius();
  const double t_level = std::clamp(along, 0.0, m.run);
  if (qz * m.run >= m.delta.z * t_level) return false;
  const double t = std::clamp((along * m.run + qz * m.delta.z) * m.inverse_length2, 0.0, 1.0);
  const double ea = along - t * m.run, ez = qz - t * m.delta.z;
  return ea * ea + across * across + ez * ez >= reach * reach;
}

/// e such that f(p + δ) <= f(p) + gradient·δ + e for all |δ| <= reach, where `at` is the sample at
/// p. Follows from a ball inside the cutter that touches the nearest place of its surface.
double curvature_bound(const CutterProfile& profile, const SweptMove& move, const model::Vec3& p,
                       const SweptSample& at, double reach);

/// e such that f(p + δ) <= max(0, f(p) + gradient·δ + e) for all |δ_a| <= half_a: what a search for
/// places outside the swept space needs. Tighter than curvature_bound beside the edges of the
/// cutter, where a block that keeps to the height of a wall never sees the edge.
double outside_bound(const CutterProfile& profile, const SweptMove& move, const model::Vec3& p,
                     const SweptSample& at, const model::Vec3& half);

}  // namespace limitgauge::simulator
