#include "verifier/swept_body.h"

#include <algorithm>
#include <cmath>

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

/// The convex function of t is minimised by bisection on the sign of its slope.
BodyDistance sloped_distance(const CutterProfile& profile, const SweptBody& body, const Vec3& p) {
  const Vec3 d = body.to - body.from;
  const auto slope_at = [&](const BodyDistance& at) { return -dot(at.gradient, d); };
  const auto at = [&](double t) { return standing_distance(profile, body.from + d * t, p); };
  const BodyDistance first = at(0), last = at(1);
  if (slope_at(first) >= 0) return first;
  if (slope_at(last) <= 0) return last;
  // Secant steps, halved in between where they stay on one side; ends within 1e-10 mm of the move.
  double low = 0, high = 1;
  BodyDistance falling = first, rising = last;
  const double span = length(d);
  for (int n = 0; n < 120 && (high - low) * span > 1e-10; ++n) {
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

BodyDistance open_body_distance(const CutterProfile& profile, const SweptBody& body,
                                const Vec3& p) {
  if (profile.flat_mm <= 0 && profile.slope == 0) return ball_distance(profile, body, p);
  const bool level = body.from.z == body.to.z;
  const bool vertical = body.from.x == body.to.x && body.from.y == body.to.y;
  if (!level && !vertical) return sloped_distance(profile, body, p);
  const double t = vertical ? 0 : level_parameter(body, p);
  const BodyDistance at = standing_distance(profile, lerp(body.from, body.to, t), p);
  return at;
}

double top_of(const CutterProfile& profile, const SweptBody& body) {
  return std::max(body.from.z, body.to.z) + profile.top_mm;
}

}  // namespace

SweptBody::SweptBody(const Vec3& a, const Vec3& b) : from(a), to(b) {
  if (a.x == b.x && a.y == b.y && b.z < a.z) std::swap(from, to);
}

BodyDistance standing_distance(const CutterProfile& profile, const Vec3& tip, const Vec3& p) {
  const double dx = p.x - tip.x, dy = p.y - tip.y, rho = std::sqrt(dx * dx + dy * dy);
  const ProfileDistance d = open_distance(profile, rho, p.z - tip.z);
  const double scale = rho > 0 ? d.by_rho / rho : 0;
  return {d.value, {dx * scale, dy * scale, d.by_height}, 0};
}

BodyDistance body_distance(const CutterProfile& profile, const SweptBody& body, const Vec3& p) {
  const double over = p.z - top_of(profile, body);
  const BodyDistance open = open_body_distance(profile, body, p);
  if (over > open.value) return {over, {0, 0, 1}, 0};
  return open;
}

double body_value(const CutterProfile& profile, const SweptBody& body, const Vec3& p) {
  return body_distance(profile, body, p).value;
}

void body_values(const CutterProfile& profile, const SweptBody& body, const Bezier& cell,
                 std::array<double, 16>& out) {
  if (profile.flat_mm <= 0 && profile.slope == 0) {
    const double top = top_of(profile, body);
    for (int k = 0; k < 16; ++k) {
      const Vec3 p{cell.x[k], cell.y[k], cell.z[k]};
      const Vec3 offset = offset_from_strip(body, profile.rounding_mm, p);
      out[k] = std::max(std::sqrt(dot(offset, offset)) - profile.rounding_mm, p.z - top);
    }
    return;
  }
  for (int k = 0; k < 16; ++k) out[k] = body_value(profile, body, cell.control(k));
}

double box_bound(const CutterProfile& profile, const model::Box3& tips, const Vec3& p) {
  const double dx = std::max({tips.low.x - p.x, 0.0, p.x - tips.high.x});
  const double dy = std::max({tips.low.y - p.y, 0.0, p.y - tips.high.y});
  // The body only widens upwards, so the lowest tip reaches furthest.
  const double open = open_distance(profile, std::sqrt(dx * dx + dy * dy), p.z - tips.low.z).value;
  return std::max(open, p.z - (tips.high.z + profile.top_mm));
}

}  // namespace limitgauge::verifier
