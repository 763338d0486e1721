#include "engine/surface/cell/mesh_bound.h"

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

/// Bounds of one cell as another sees them.
class Seen {
 public:
  Seen(const DerivativeBounds& from, const DerivativeBounds& cell)
      : cosine_(std::abs(dot(from.normal, cell.normal))),
        sine_(length(cross(from.normal, cell.normal))),
        stretch_(stretch(from.map(cell.du), from.map(cell.dv))),
        stand_(from.map.length(cell.normal)) {}
  SplitBound operator()(const SplitBound& b) const {
    return {cosine_ * b.along + sine_ * b.across, sine_ * b.along + b.across,
            stretch_ * b.mapped + stand_ * b.along};
  }

 private:
  double cosine_, sine_, stretch_, stand_;
};

void widen(SplitBound& all, const SplitBound& by) {
  all.along = std::max(all.along, by.along);
  all.across = std::max(all.across, by.across);
  all.mapped = std::max(all.mapped, by.mapped);
}

}  // namespace

double side_bend(const DerivativeBounds& cell, bool in_u, const Vec3& normal) {
  const SplitBound& second = in_u ? cell.duu : cell.dvv;
  const double turn = (second.across + cell.duv.across) / 2;
  const double across =
      std::max(length(in_u ? cell.dv : cell.du), length(in_u ? cell.dv_moved : cell.du_moved));
  const double least = least_area(cell) / across;
  const double askew = in_u ? swing(cell.du, cell.du_moved) : swing(cell.dv, cell.dv_moved);
  const double own = in_u ? cell.bend_u : cell.bend_v;
  const double aside = (own + cell.duv.across) / 2;
  const double turned = least > turn ? std::min(1.0, askew + aside / (least - turn)) : 1.0;
  const double tilt = length(cross(normal, cell.normal));
  return own + (turned + tilt) * second.across + tilt * second.along;
}

MeshBound::MeshBound(const DerivativeBounds& cell, std::span<const DerivativeBounds* const> block,
                     const Bend& bend) {
  plain_ = sliding_ = std::numeric_limits<double>::infinity();
  SplitBound uu, uv, vv;
  for (const DerivativeBounds* c : block) {
    if (!c->proven) return;
    const Seen seen(cell, *c);
    widen(uu, seen(c->duu));
    widen(uv, seen(c->duv));
    widen(vv, seen(c->dvv));
  }
  const double off = (uu.along + 2 * uv.along + vv.along) / 8;
  slide_ = (uu.mapped + 2 * uv.mapped + vv.mapped) / 8;
  plain_ = std::hypot(off, (uu.across + 2 * uv.across + vv.across) / 8);
  const LevelRange u{std::max(1.0, cell.map.length(cell.du_moved)),
                     kHalfBlock * (uu.mapped + uv.mapped), kHalfBlock * (uu.along + uv.along)};
  const LevelRange v{std::max(1.0, cell.map.length(cell.dv_moved)),
                     kHalfBlock * (uv.mapped + vv.mapped), kHalfBlock * (uv.along + vv.along)};
  const double least = least_area(cell) / length(cross(cell.du, cell.dv));
  if (2 * u.turn * v.at > least || 2 * v.turn * u.at > least) return;
  const double area = least - u.at * v.turn - v.at * u.turn - u.turn * v.turn;
  if (!(area > 0)) return;
  reach_ = area / std::max(u.largest(), v.largest());
  const double slope = (v.largest() * u.rise + u.largest() * v.rise) / area;
  const double rim = 2 * bend.rim / 8;
  const double aside = 2 * std::max(bend.rim, bend.smooth) / 8;
  sliding_ = off + slope * (slide_ + cell.map.norm() * aside) + rim;
  meeting_ = {bend.smooth / 8, slope * cell.map.norm(), reach_ / cell.map.norm()};
}

double MeshBound::at(double scale) const {
  return scale * (slides(scale) ? std::min(plain_, sliding_) : plain_);
}

Meeting MeshBound::meeting(double scale) const {
  if (!slides(scale)) return {0, std::numeric_limits<double>::infinity(), 0};
  return {meeting_.bulge_mm * scale, meeting_.slope, meeting_.width_mm};
}

Meeting worse(const Meeting& a, const Meeting& b) {
  return {std::max(a.bulge_mm, b.bulge_mm), std::max(a.slope, b.slope),
          std::min(a.width_mm, b.width_mm)};
}

}  // namespace limitgauge::engine::surface
