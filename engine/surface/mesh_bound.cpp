#include "engine/surface/mesh_bound.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace limitgauge::engine::surface {
namespace {

/// From the middle of a cell to the far side of its neighbour.
constexpr double kHalfBlock = 1.5;

struct LevelRange {
  double at = 0, turn = 0, rise = 0;  ///< length at the middle, and change across and along m
  double largest() const { return at + turn; }
};

/// Least of det(du, dv, m) for all shares of the offset: a quadratic of the share.
double least_area(const DerivativeBounds& c) {
  const Vec3 change_u = c.du_moved - c.du, change_v = c.dv_moved - c.dv;
  const auto area = [&](const Vec3& a, const Vec3& b) { return dot(c.normal, cross(a, b)); };
  const double q0 = area(c.du, c.dv), q2 = area(change_u, change_v);
  const double q1 = area(change_u, c.dv) + area(c.du, change_v);
  double least = std::min(q0, q0 + q1 + q2);
  if (q2 > 0 && q1 < 0 && q1 > -2 * q2) least = std::min(least, q0 - q1 * q1 / (4 * q2));
  return least;
}

/// Largest sine of the angle between `a` and a vector between `a` and `b`.
double swing(const Vec3& a, const Vec3& b) {
  const double scale = length(a) * length(b);
  return dot(a, b) > 0 && scale > 0 ? length(cross(a, b)) / scale : 1.0;
}

}  // namespace

double side_bend(const DerivativeBounds& cell, bool in_u, const Vec3& normal) {
  const SplitBound& second = in_u ? cell.duu : cell.dvv;
  const double turn = (second.across + cell.duv.across) / 2;
  const double across =
      std::max(length(in_u ? cell.dv : cell.du), length(in_u ? cell.dv_moved : cell.du_moved));
  const double least = least_area(cell) / across;
  const double askew = in_u ? swing(cell.du, cell.du_moved) : swing(cell.dv, cell.dv_moved);
  const double turned = least > turn ? std::min(1.0, askew + turn / least) : 1.0;
  const double tilt = length(cross(normal, cell.normal));
  return (in_u ? cell.bend_u : cell.bend_v) + (turned + tilt) * second.across + tilt * second.along;
}

SplitBound seen_from(const Vec3& normal, const DerivativeBounds& cell, const SplitBound& bound) {
  const double cosine = std::abs(dot(normal, cell.normal));
  const double sine = length(cross(normal, cell.normal));
  return {cosine * bound.along + sine * bound.across, sine * bound.along + bound.across};
}

MeshBound::MeshBound(const DerivativeBounds& cell, std::span<const DerivativeBounds* const> block,
                     double bend) {
  plain_ = sliding_ = std::numeric_limits<double>::infinity();
  SplitBound uu, uv, vv;
  const auto widen = [&](SplitBound& all, const DerivativeBounds& of, const SplitBound& by) {
    const SplitBound seen = surface::seen_from(cell.normal, of, by);
    all = {std::max(all.along, seen.along), std::max(all.across, seen.across)};
  };
  for (const DerivativeBounds* c : block) {
    if (!c->proven) return;
    widen(uu, *c, c->duu);
    widen(uv, *c, c->duv);
    widen(vv, *c, c->dvv);
  }
  const double off = (uu.along + 2 * uv.along + vv.along) / 8;
  slide_ = (uu.across + 2 * uv.across + vv.across) / 8;
  plain_ = std::hypot(off, slide_);
  const LevelRange u{std::max(length(cell.du), length(cell.du_moved)),
                     kHalfBlock * (uu.across + uv.across), kHalfBlock * (uu.along + uv.along)};
  const LevelRange v{std::max(length(cell.dv), length(cell.dv_moved)),
                     kHalfBlock * (uv.across + vv.across), kHalfBlock * (uv.along + vv.along)};
  const double least = least_area(cell);
  if (2 * u.turn * v.at > least || 2 * v.turn * u.at > least) return;
  const double area = least - u.at * v.turn - v.at * u.turn - u.turn * v.turn;
  if (!(area > 0)) return;
  reach_ = area / std::max(u.largest(), v.largest());
  const double slope = (v.largest() * u.rise + u.largest() * v.rise) / area;
  sliding_ = off + slope * slide_ + 2 * (1 + slope) * bend / 8;
}

double MeshBound::at(double scale) const {
  const bool slides = 2 * slide_ * scale < reach_;
  return scale * (slides ? std::min(plain_, sliding_) : plain_);
}

}  // namespace limitgauge::engine::surface
