#include "simulator/sweep/swept_distance.h"

#include <algorithm>
#include <cmath>

#include "simulator/tolerance.h"

namespace limitgauge::simulator {
namespace {

using model::Vec3;

constexpr int kMostSteps = 100;

// The cutter's distance with the tip at parameter t; slope is its derivative by t.
struct AlongMove {
  double t, value, slope;
  Vec3 gradient;
};

AlongMove at_parameter(const CutterProfile& profile, const SweptMove& m, const Vec3& p, double t) {
  const Vec3 q = p - (m.start + m.delta * t);
  const double rho = std::sqrt(q.x * q.x + q.y * q.y);
  const MeridianSample s = profile.sample(rho, q.z);
  const double level = rho > 0 ? s.g_rho / rho : 0.0;
  const Vec3 g{level * q.x, level * q.y, s.g_z};
  return {t, s.distance, -dot(g, m.delta), g};
}

SweptSample as_sample(const AlongMove& a) {
  return {a.value, a.gradient, a.t};
}

double nearest_level_parameter(const SweptMove& m, const Vec3& p) {
  const double along = (p.x - m.start.x) * m.delta.x + (p.y - m.start.y) * m.delta.y;
  return std::clamp(along * m.inverse_run2, 0.0, 1.0);
}

// Where the tangents at both ends of the bracket meet: the minimum is not below that.
struct TangentMeeting {
  double t, value;
};
TangentMeeting meet(const AlongMove& a, const AlongMove& b) {
  const double t = (b.value - a.value + a.slope * a.t - b.slope * b.t) / (a.slope - b.slope);
  return {t, a.value + a.slope * (t - a.t)};
}

// At a kink neither side's gradient supports f; the mean whose slope along the move is zero does.
SweptSample settle(const AlongMove& a, const AlongMove& b) {
  const AlongMove& best = a.value <= b.value ? a : b;
  const double share = b.slope / (b.slope - a.slope);
  return {best.value, a.gradient * share + b.gradient * (1 - share), best.t};
}

double next_parameter(const AlongMove& a, const AlongMove& b, const TangentMeeting& m, int step) {
  const double width = b.t - a.t;
  double t = a.t + 0.5 * width;
  if (step % 3 == 0) t = a.t - a.slope * width / (b.slope - a.slope);
  if (step % 3 == 1) t = m.t;
  return t > a.t && t < b.t ? t : a.t + 0.5 * width;
}

// The least between two places towards which it falls from both sides.
SweptSample least_between(const CutterProfile& profile, const SweptMove& m, const Vec3& p,
                          AlongMove a, AlongMove b) {
  for (int step = 0; step < kMostSteps; ++step) {
    const TangentMeeting meeting = meet(a, b);
    if (std::min(a.value, b.value) - meeting.value <= kLeastAlongMove_mm) break;
    const double t = next_parameter(a, b, meeting, step);
    if (!(t > a.t && t < b.t)) break;
    const AlongMove c = at_parameter(profile, m, p, t);
    if (c.slope == 0) return as_sample(c);
    (c.slope < 0 ? a : b) = c;
  }
  return settle(a, b);
}

// Twice as far towards the least as it would lie if the level distance to the axis were all that
// bends: where it is, as beside moves that are all but level, that is just beyond the least.
double beyond_least(const SweptMove& m, const Vec3& p, const AlongMove& a) {
  const double end = a.slope < 0 ? 1 : 0;
  const Vec3 q = p - (m.start + m.delta * a.t);
  const double rho = std::sqrt(q.x * q.x + q.y * q.y);
  const double steep = std::sqrt(a.gradient.x * a.gradient.x + a.gradient.y * a.gradient.y);
  const double t = a.t - 2 * a.slope * rho / (steep * m.run * m.run);
  return t > 0 && t < 1 ? t : end;
}

// The distance is convex along the move. Sought from where a level move's least would be: most
// leasts are near that, or at the end that it falls towards.
SweptSample minimise(const CutterProfile& profile, const SweptMove& m, const Vec3& p) {
  AlongMove from = at_parameter(profile, m, p, nearest_level_parameter(m, p));
  const double end = from.slope < 0 ? 1 : 0;
  for (const double t : {beyond_least(m, p, from), end}) {
    if (from.slope == 0 || from.t == end) break;
    const AlongMove next = at_parameter(profile, m, p, t);
    if (next.slope == 0) return as_sample(next);
    if ((next.slope < 0) != (from.slope < 0))
      return end > 0 ? least_between(profile, m, p, from, next)
                     : least_between(profile, m, p, next, from);
    from = next;
  }
  return as_sample(from);
}

// A flat's distance depends on |z − middle|: take the position whose middle is nearest.
SweptSample flat_plunge(const CutterProfile& profile, const SweptMove& m, const Vec3& p) {
  const double t = std::clamp((p.z - profile.length() / 2 - m.start.z) / m.delta.z, 0.0, 1.0);
  SweptSample s = as_sample(at_parameter(profile, m, p, t));
  if (t > 0 && t < 1) s.gradient.z = 0;
  return s;
}

// Distance to all that lies above the move of the ball's centre: the shaft's top left out.
SweptSample ball_without_top(double radius, const SweptMove& m, const Vec3& p) {
  const Vec3 q{p.x - m.start.x, p.y - m.start.y, p.z - m.start.z - radius};
  const double along = q.x * m.along_x + q.y * m.along_y;
  const double across = q.y * m.along_x - q.x * m.along_y;
  const double t_level =
      m.vertical() ? (m.delta.z < 0 ? 1.0 : 0.0) : std::clamp(along / m.run, 0.0, 1.0);
  const bool above = q.z >= m.delta.z * t_level;
  const double t_line = std::clamp((along * m.run + q.z * m.delta.z) * m.inverse_length2, 0.0, 1.0);
  const double t = above ? t_level : t_line;
  const double e_along = along - t * m.run;
  const double e_z = above ? 0.0 : q.z - t * m.delta.z;
  const double r = std::sqrt(e_along * e_along + across * across + e_z * e_z);
  if (r == 0) return {-radius, {}, t};
  const Vec3 e{e_along * m.along_x - across * m.along_y, e_along * m.along_y + across * m.along_x,
               e_z};
  return {r - radius, e / r, t};
}

}  // namespace

SweptMove::SweptMove(const Vec3& from, const Vec3& to, std::uint32_t index_in_path)
    : start(from), delta(to - from), index(index_in_path) {
  const double run2 = delta.x * delta.x + delta.y * delta.y;
  const double length2 = run2 + delta.z * delta.z;
  if (length2 > 0) inverse_length2 = 1 / length2;
  if (run2 == 0) return;
  run = std::sqrt(run2);
  inverse_run2 = 1 / run2;
  along_x = delta.x / run;
  along_y = delta.y / run;
}

SweptSample swept_distance(const CutterProfile& profile, const SweptMove& move, const Vec3& p) {
  if (profile.is_ball()) {
    const SweptSample s = ball_without_top(profile.corner_radius(), move, p);
    const double over_top = p.z - move.start.z - s.t * move.delta.z - profile.length();
    if (over_top <= s.distance && over_top <= 0) return s;
  }
  if (move.level())
    return as_sample(at_parameter(profile, move, p, nearest_level_parameter(move, p)));
  if (move.vertical() && profile.is_flat()) return flat_plunge(profile, move, p);
  return minimise(profile, move, p);
}

double curvature_bound(const CutterProfile& profile, const SweptMove& move, const Vec3& p,
                       const SweptSample& at, double reach) {
  const Vec3 q = p - (move.start + move.delta * at.t);
  const double rho = std::sqrt(q.x * q.x + q.y * q.y);
  // The bound holds for the gradient of the cutter standing at t; `at` may hold another one.
  const double turned =
      reach * distance(at_parameter(profile, move, p, at.t).gradient, at.gradient);
  if (profile.flat_below(rho, q.z, reach)) return turned;
  const double to_centre = at.distance + profile.inscribed_radius(rho, q.z);
  if (to_centre <= 0) return 2 * reach;
  return std::min(2 * reach, reach * reach / (2 * to_centre) + turned);
}

double outside_bound(const CutterProfile& profile, const SweptMove& move, const Vec3& p,
                     const SweptSample& at, const Vec3& half) {
  const double general = curvature_bound(profile, move, p, at, length(half));
  const Vec3 q = p - (move.start + move.delta * at.t);
  const double rho = std::sqrt(q.x * q.x + q.y * q.y),
               level = std::sqrt(half.x * half.x + half.y * half.y);
  // A move straight up or down goes on doing what it does at t, as far as it leads.
  const double from = move.vertical() ? -at.t * move.delta.z : 0,
               to = move.vertical() ? (1 - at.t) * move.delta.z : 0;
  const double below = std::max(-from, -to), above = std::max(from, to);
  if (!profile.upright_between(q.z - half.z, q.z + half.z, below, above) || rho <= 0)
    return general;
  // At those heights the cutter is a cylinder, and the level distance to its axis bends by 1/ρ.
  const Vec3 outward{q.x / rho, q.y / rho, 0};
  const double turned = length(half) * distance(outward, at.gradient);
  const double offset = rho - profile.largest_radius() - at.distance;
  return std::min(general, offset + level * level / (2 * rho) + turned);
}

}  // namespace limitgauge::simulator
