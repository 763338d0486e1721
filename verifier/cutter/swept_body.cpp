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

/// The least of a convex function of t, given with its gradient in p, by secant steps and bisection
/// on the sign of its slope along the move `d`.
template <class At>
BodyDistance least_along(const Vec3& d, At&& at) {
  const auto slope_at = [&](const BodyDistance& here) { return -dot(here.gradient, d); };
  const BodyDistance first = at(0), last = at(1);
  if (slope_at(first) >= 0) return first;
  if (slope_at(last) <= 0) return last;
  // Secant steps, halved in between where they stay on one side; ends within kAlongMove_mm of the
  // place.
  double low = 0, high = 1;
  BodyDistance falling = first, rising = last;
  const double span = length(d);
  for (int n = 0; n < 120 && (high - low) * span > kAlongMove_mm; ++n) {
    const double f = slope_at(falling), r = slope_at(rising);
    const double secant = low - f * (high - low) / (r - f);
    const double inner = (high - low) * 1e-3;
    const double t = n % 2 == 0 ? std::clamp(secant, low + inner, high - inner) : (low + high) / 2;
    if (t <= low || t >= high) break;
    const BodyDistance here = at(t);
    if (slope_at(here) < 0)
      low = t, falling = here;
    else
      high = t, rising = here;
  }
  // At a kink no single position has a level slope, but a mean of the two sides' planes does.
  const double f = slope_at(falling), r = slope_at(rising);
  const double weight = r - f > 0 ? r / (r - f) : 0.5;
  const double value = std::min(falling.value, rising.value);
  const double spread = std::abs(falling.value - rising.value);
  const double slack = spread + span * (high - low) * 4;
  return {value, falling.gradient * weight + rising.gradient * (1 - weight), slack};
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
  return least_along(body.to - body.from, [&](double t) {
    return standing_distance(profile, lerp(body.from, body.to, t), p);
  });
}

BodyDistance closed_body_distance(const CutterProfile& profile, const SweptBody& body,
                                  const Vec3& p) {
  const Vec3 d = body.to - body.from;
  if (is_level(body))
    return closed_standing_distance(profile, lerp(body.from, body.to, level_parameter(body, p)), p);
  return least_along(d, [&](double t) {
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
  const double dx = std::max({tips.low.x - p.x, 0.0, p.x - tips.high.x});
  const double dy = std::max({tips.low.y - p.y, 0.0, p.y - tips.high.y});
  if (profile.is_ball()) {
    const double dz = std::max(0.0, tips.low.z + profile.rounding_mm - p.z);
    const double open = std::sqrt(dx * dx + dy * dy + dz * dz) - profile.rounding_mm;
    return std::max(open, p.z - (tips.high.z + profile.top_mm));
  }
  // The endless cutter holds the body and only widens upwards: its lowest tip reaches furthest.
  const double open = open_distance(profile, std::sqrt(dx * dx + dy * dy), p.z - tips.low.z).value;
  return std::max(open, p.z - (tips.high.z + profile.top_mm));
}

}  // namespace limitgauge::verifier
