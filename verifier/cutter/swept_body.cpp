#include "verifier/cutter/swept_body.h"

#include <algorithm>
#include <cmath>

#include "verifier/tolerance.h"

namespace limitgauge::verifier {
namespace {

using model::Vec3;

/// A ball's core is the vertical half line above its centre; swept, a vertical strip, open upwards.
/// Nearest offset from the strip to p.
inline Vec3 offset_from_strip(const SweptBody& body, double rounding, const Vec3& p) {
  const Vec3 d = body.to - body.from;
  const double wx = p.x - body.from.x, wy = p.y - body.from.y, wz = p.z - body.from.z - rounding;
  const double level = d.x * d.x + d.y * d.y, whole = level + d.z * d.z;
  const double along = wx * d.x + wy * d.y;
  const double t_level = level > 0 ? std::clamp(along / level, 0.0, 1.0) : 0.0;
  const bool above = wz >= t_level * d.z;
  const double t_edge = whole > 0 ? std::clamp((along + wz * d.z) / whole, 0.0, 1.0) : 0.0;
  const double t = above ? t_level : t_edge;
  return {wx - t * d.x, wy - t * d.y, above ? 0.0 : wz - t * d.z};
}

double ball_value(const CutterProfile& profile, const SweptBody& body, const Vec3& p) {
  return length(offset_from_strip(body, profile.rounding_mm, p)) - profile.rounding_mm;
}

BodyDistance ball_distance(const CutterProfile& profile, const SweptBody& body, const Vec3& p) {
  const Vec3 offset = offset_from_strip(body, profile.rounding_mm, p);
  const double l = length(offset);
  return {l - profile.rounding_mm, l > 0 ? offset / l : Vec3{}, 0};
}

/// A level move's nearest position is the nearest in plan; a vertical one's is the lowest.
double level_parameter(const SweptBody& body, const Vec3& p) {
  const Vec3 d = body.to - body.from;
  const double level = d.x * d.x + d.y * d.y;
  if (!(level > 0)) return 0;
  return std::clamp(((p.x - body.from.x) * d.x + (p.y - body.from.y) * d.y) / level, 0.0, 1.0);
}

/// The cutter standing at one place of a move: its distance to p, and how fast that grows with t.
struct OnMove {
  double t = 0;
  BodyDistance here;
  double slope = 0;
};

/// How low the tangents at two places leave room for the least between them, and where they meet.
OnMove tangents_meet(const OnMove& falling, const OnMove& rising) {
  OnMove out;
  out.t = (rising.here.value - falling.here.value + falling.slope * falling.t -
           rising.slope * rising.t) /
          (falling.slope - rising.slope);
  out.here.value = falling.here.value + falling.slope * (out.t - falling.t);
  return out;
}

/// The least between a place from which the distance falls and one from which it rises. By turns
/// where the tangents meet, where the slope would vanish were it linear, and half-way; ends where
/// the least is known to kAlongMove_mm. No single position need have a level slope (at a kink none
/// has), but a mean of the two planes does: with the tangents' meeting it supports d, so that the
/// slack is proven.
template <class Look>
BodyDistance least_between(OnMove falling, OnMove rising, const Look& look) {
  OnMove lowest = tangents_meet(falling, rising);
  const auto least = [&] { return std::min(falling.here.value, rising.here.value); };
  for (int n = 0; n < 120 && least() - lowest.here.value > kAlongMove_mm; ++n) {
    const double middle = (falling.t + rising.t) / 2, width = rising.t - falling.t;
    double t = middle;
    if (n % 3 == 0) t = lowest.t;
    if (n % 3 == 1) t = falling.t - falling.slope * width / (rising.slope - falling.slope);
    if (!(t > falling.t && t < rising.t)) t = middle;
    if (!(t > falling.t && t < rising.t)) break;
    const OnMove here = look(t);
    (here.slope < 0 ? falling : rising) = here;
    if (rising.slope == 0) return rising.here;
    lowest = tangents_meet(falling, rising);
  }
  const double weight = rising.slope / (rising.slope - falling.slope);
  return {least(), falling.here.gradient * weight + rising.here.gradient * (1 - weight),
          std::max(0.0, least() - lowest.here.value)};
}

/// From a place of the move, about twice as far as the least would lie if nothing bent but the
/// level distance to the axis; 0 or 1 where that is not on the move.
double beyond_least(const SweptBody& body, const Vec3& p, const OnMove& from) {
  const Vec3 d = body.to - body.from, tip = lerp(body.from, body.to, from.t);
  const Vec3 g = from.here.gradient;
  const double bend = std::sqrt(g.x * g.x + g.y * g.y) * (d.x * d.x + d.y * d.y);
  const double rho = std::sqrt((p.x - tip.x) * (p.x - tip.x) + (p.y - tip.y) * (p.y - tip.y));
  const double t = from.t - 2 * from.slope * rho / bend;
  return t > 0 && t < 1 ? t : (from.slope < 0 ? 1.0 : 0.0);
}

/// The least along the move of a distance that is convex jointly in p and in where the cutter
/// stands, given with its gradient in p. Sought from where a level move has it: moves that are all
/// but level, as rounded coordinates make them, have it there but for little.
template <class At>
BodyDistance least_along(const SweptBody& body, const Vec3& p, const At& at) {
  const Vec3 d = body.to - body.from;
  const auto look = [&](double t) {
    OnMove out{t, at(t), 0};
    out.slope = -dot(out.here.gradient, d);
    return out;
  };
  OnMove from = look(level_parameter(body, p));
  const double end = from.slope < 0 ? 1 : 0;
  for (const double t : {beyond_least(body, p, from), end}) {
    if (from.slope == 0 || from.t == end) break;
    const OnMove next = look(t);
    if (next.slope != 0 && (next.slope < 0) != (from.slope < 0))
      return end > 0 ? least_between(from, next, look) : least_between(next, from, look);
    from = next;
  }
  return from.here;
}

bool is_level(const SweptBody& body) {
  return body.from.z == body.to.z;
}
bool is_vertical(const SweptBody& body) {
  return body.from.x == body.to.x && body.from.y == body.to.y;
}

/// Of the endless cutter.
BodyDistance open_body_distance(const CutterProfile& profile, const SweptBody& body,
                                const Vec3& p) {
  if (profile.is_ball()) return ball_distance(profile, body, p);
  // Only widening upwards, it reaches furthest from the lowest position of a vertical move.
  if (is_vertical(body)) return standing_distance(profile, body.from, p);
  if (is_level(body))
    return standing_distance(profile, lerp(body.from, body.to, level_parameter(body, p)), p);
  return least_along(body, p, [&](double t) {
    return standing_distance(profile, lerp(body.from, body.to, t), p);
  });
}

BodyDistance closed_body_distance(const CutterProfile& profile, const SweptBody& body,
                                  const Vec3& p) {
  if (is_level(body))
    return closed_standing_distance(profile, lerp(body.from, body.to, level_parameter(body, p)), p);
  return least_along(body, p, [&](double t) {
    return closed_standing_distance(profile, lerp(body.from, body.to, t), p);
  });
}

/// The top cannot matter where the point, and the point of the wall nearest to it, lie below it at
/// every position of the move, by more than the depth in the cutter.
bool below_tops(const CutterProfile& profile, const SweptBody& body, double z, double open) {
  const double lowest_top = std::min(body.from.z, body.to.z) + profile.top_mm;
  return z - lowest_top + profile.slope * std::max(open, 0.0) <= std::min(open, 0.0);
}

BodyDistance in_space(const ProfileDistance& d, double rho, double dx, double dy) {
  const double scale = rho > 0 ? d.by_rho / rho : 0;
  return {d.value, {dx * scale, dy * scale, d.by_height}, 0};
}

}  // namespace

SweptBody::SweptBody(const Vec3& a, const Vec3& b) : from(a), to(b) {
  if (a.x == b.x && a.y == b.y && b.z < a.z) std::swap(from, to);
}

double least_by_plane(const BodyDistance& d, const Vec3& at, const Bezier& cell) {
  double least = d.value;
  for (int k = 0; k < 16; ++k)
    least = std::min(least, d.value + dot(d.gradient, cell.control(k) - at));
  return least;
}

BodyDistance standing_distance(const CutterProfile& profile, const Vec3& tip, const Vec3& p) {
  const double dx = p.x - tip.x, dy = p.y - tip.y, rho = std::sqrt(dx * dx + dy * dy);
  return in_space(open_distance(profile, rho, p.z - tip.z), rho, dx, dy);
}

BodyDistance closed_standing_distance(const CutterProfile& profile, const Vec3& tip,
                                      const Vec3& p) {
  const double dx = p.x - tip.x, dy = p.y - tip.y, rho = std::sqrt(dx * dx + dy * dy);
  return in_space(closed_distance(profile, rho, p.z - tip.z), rho, dx, dy);
}

BodyDistance body_distance(const CutterProfile& profile, const SweptBody& body, const Vec3& p) {
  // Beside a side that leans inwards the endless cutter is another body.
  if (profile.undercuts()) return closed_body_distance(profile, body, p);
  const BodyDistance open = open_body_distance(profile, body, p);
  if (below_tops(profile, body, p.z, open.value)) return open;
  return closed_body_distance(profile, body, p);
}

double body_value(const CutterProfile& profile, const SweptBody& body, const Vec3& p) {
  if (profile.is_ball()) {
    const double open = ball_value(profile, body, p);
    if (below_tops(profile, body, p.z, open)) return open;
  }
  return body_distance(profile, body, p).value;
}

void body_values(const CutterProfile& profile, const SweptBody& body, const Bezier& cell,
                 std::array<double, 16>& out) {
  if (profile.is_ball() &&
      below_tops(profile, body, control_box(cell).high.z, -profile.rounding_mm)) {
    for (int k = 0; k < 16; ++k) out[k] = ball_value(profile, body, cell.control(k));
    return;
  }
  for (int k = 0; k < 16; ++k) out[k] = body_value(profile, body, cell.control(k));
}

double box_bound(const CutterProfile& profile, const model::Box3& tips, const Vec3& p) {
  if (profile.is_ball()) {
    const double open = std::sqrt(square_from_cores(profile, tips, p)) - profile.rounding_mm;
    return std::max(open, p.z - (tips.high.z + profile.top_mm));
  }
  const double dx = std::max({tips.low.x - p.x, 0.0, p.x - tips.high.x});
  const double dy = std::max({tips.low.y - p.y, 0.0, p.y - tips.high.y});
  // The endless cutter holds the body and only widens upwards: its lowest tip reaches furthest.
  const double open = open_value(profile, std::sqrt(dx * dx + dy * dy), p.z - tips.low.z);
  return std::max(open, p.z - (tips.high.z + profile.top_mm));
}

}  // namespace limitgauge::verifier
