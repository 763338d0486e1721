#pragma once

#include <algorithm>
#include <array>

#include "verifier/cutter/cutter_profile.h"
#include "verifier/surface/bezier.h"

namespace limitgauge::verifier {

/// The space swept by the fluted part of a cutter along one straight move of its tip. The
/// certificate rests on its distance, so that it is the verifier's own and not the simulator's.
struct SweptBody {
  model::Vec3 from, to;  ///< tip positions; a vertical move is stored lowest end first
  SweptBody(const model::Vec3& a, const model::Vec3& b);
};

/// d at a point, and a supporting plane of d there: d(q) ≥ value + gradient·(q − p) − slack for
/// every q within `slack`'s validity, all of space. `slack_mm` is zero for every closed form and
/// below 1e-9 where the position along the move is found by iteration.
struct BodyDistance {
  double value = 0;
  model::Vec3 gradient;
  double slack_mm = 0;
};

/// The least over `cell` that the supporting plane at `at` leaves to `d`, a distance there without
/// slack.
double least_by_plane(const BodyDistance& d, const model::Vec3& at, const Bezier& cell);

/// Signed distance from `p` to the endless cutter (`open_distance`) with its tip at `tip`, and to
/// the cutter that ends at its top.
BodyDistance standing_distance(const CutterProfile& profile, const model::Vec3& tip,
                               const model::Vec3& p);
BodyDistance closed_standing_distance(const CutterProfile& profile, const model::Vec3& tip,
                                      const model::Vec3& p);

/// The least signed distance from `p` to the cutter over all positions of the move. Convex in p (a
/// partial minimum of a jointly convex function), with the sign and zero set of the swept volume
/// and its exact distance outside; inside, the depth into one position of the cutter.
BodyDistance body_distance(const CutterProfile& profile, const SweptBody& body,
                           const model::Vec3& p);
double body_value(const CutterProfile& profile, const SweptBody& body, const model::Vec3& p);
/// body_value at the sixteen control points of `cell`.
void body_values(const CutterProfile& profile, const SweptBody& body, const Bezier& cell,
                 std::array<double, 16>& out);
/// Of a ball: the square of the distance from p to all its cores may be, its tips in `tips`.
inline double square_from_cores(const CutterProfile& ball, const model::Box3& tips,
                                const model::Vec3& p) {
  const double dx = std::max({tips.low.x - p.x, 0.0, p.x - tips.high.x});
  const double dy = std::max({tips.low.y - p.y, 0.0, p.y - tips.high.y});
  const double dz = std::max(0.0, tips.low.z + ball.rounding_mm - p.z);
  return dx * dx + dy * dy + dz * dz;
}
/// A lower bound of d(p) over all moves whose tips stay in `tips`.
double box_bound(const CutterProfile& profile, const model::Box3& tips, const model::Vec3& p);

}  // namespace limitgauge::verifier
