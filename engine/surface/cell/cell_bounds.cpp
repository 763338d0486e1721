#include "engine/surface/cell/cell_bounds.h"

#include <algorithm>
#include <cmath>

namespace limitgauge::engine::surface {
namespace {

double norm(const SplitBound& b) {
  return std::hypot(b.along, b.across);
}

SplitBound seen_from(const Differences& d, const DerivativeBounds& cell) {
  SplitBound bound;
  double across_squared = 0;
  Longest mapped;
  d.for_each([&](const Vec3& x) {
    const double height = dot(cell.normal, x);
    bound.along = std::max(bound.along, std::abs(height));
    across_squared = std::max(across_squared, length_squared(x - cell.normal * height));
    mapped.see(cell.map(x));
  });
  bound.across = std::sqrt(across_squared);
  bound.mapped = mapped.length();
  return bound;
}

double along(const Differences& d, const Vec3& direction) {
  double largest = 0;
  d.for_each([&](const Vec3& x) { largest = std::max(largest, std::abs(dot(direction, x))); });
  return largest;
}

using Weights = std::array<double, 4>;
// The uniform cubic B-splines and their derivatives in the middle of a segment.
constexpr Weights kValue = {1.0 / 48, 23.0 / 48, 23.0 / 48, 1.0 / 48};
constexpr Weights kFirst = {-1.0 / 8, -5.0 / 8, 5.0 / 8, 1.0 / 8};
constexpr Weights kSecond = {0.5, -0.5, -0.5, 0.5};

Vec3 middle(const ControlCell& cell, const Weights& in_u, const Weights& in_v) {
  Vec3 sum;
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 4; ++i) sum += cell.at(i, j) * (in_u[i] * in_v[j]);
  return sum;
}

/// The limit surface over a cell, to be moved out.
struct OffsetBase {
  const DerivativeBounds& s;
  double area = 0;        ///< lower bound of |N|
  double du = 0, dv = 0;  ///< upper bounds of |S_u| and |S_v|
  double tilt = 0;        ///< upper bound of the sine between n and the normal at the middle

  explicit OffsetBase(const DerivativeBounds& limit) : s(limit) {
    const double turn_u = (s.duu.across + s.duv.across) / 2,
                 rise_u = (s.duu.along + s.duv.along) / 2;
    const double turn_v = (s.duv.across + s.dvv.across) / 2,
                 rise_v = (s.duv.along + s.dvv.along) / 2;
    const double at_u = length(s.du), at_v = length(s.dv);
    const double share_u = (s.duu.mapped + s.duv.mapped) / 2;
    const double share_v = (s.duv.mapped + s.dvv.mapped) / 2;
    area = length(cross(s.du, s.dv)) * (1 - share_u - share_v - share_u * share_v);
    du = at_u + std::hypot(turn_u, rise_u);
    dv = at_v + std::hypot(turn_v, rise_v);
    // N leaves the normal at the middle by at most this over its part along it, which is `area`.
    tilt = std::min(1.0, (dv * rise_u + du * rise_v) / area);
  }
  /// Seen from n, wherever in the cell.
  SplitBound turned(const SplitBound& b) const {
    return {b.along + tilt * b.across, b.across + tilt * b.along, 0};
  }
};

/// How far the middle's n turns for a step in u and v.
std::array<Vec3, 2> normal_change(const ControlCell& cell, const DerivativeBounds& s) {
  const Vec3 uu = middle(cell, kSecond, kValue), uv = middle(cell, kFirst, kFirst),
             vv = middle(cell, kValue, kSecond);
  const double area = length(cross(s.du, s.dv));
  const auto across = [&](const Vec3& n_change) {
    return (n_change - s.normal * dot(s.normal, n_change)) / area;
  };
  return {across(cross(uu, s.dv) + cross(s.du, uv)), across(cross(uv, s.dv) + cross(s.du, vv))};
}

}  // namespace

DerivativeBounds limit_bounds(const ControlCell& cell) {
  DerivativeBounds b;
  b.du = middle(cell, kFirst, kValue);
  b.dv = middle(cell, kValue, kFirst);
  b.du_moved = b.du;
  b.dv_moved = b.dv;
  b.normal = cross(b.du, b.dv);
  if (!(length_squared(b.normal) > 0)) return b;
  b.normal = normalized(b.normal);
  b.proven = true;
  b.map = LevelMap(b.normal, b.du, b.dv);
  const Differences uu(cell, 2, 0), vv(cell, 0, 2);
  b.duu = seen_from(uu, b);
  b.duv = seen_from(Differences(cell, 1, 1), b);
  b.dvv = seen_from(vv, b);
  b.bend_u = along(uu, normalized(cross(b.normal, b.du)));
  b.bend_v = along(vv, normalized(cross(b.normal, b.dv)));
  return b;
}

DerivativeBounds offset_bounds(const ControlCell& cell, double offset_mm) {
  DerivativeBounds b = limit_bounds(cell);
  if (!b.proven || offset_mm <= 0) return b;
  const OffsetBase base(b);
  if (!(base.area > 0)) {
    b.proven = false;
    return b;
  }
  const SplitBound uu = base.turned(b.duu), uv = base.turned(b.duv), vv = base.turned(b.dvv);
  const auto third = [&](int in_u, int in_v) {
    return base.turned(seen_from(Differences(cell, in_u, in_v), b)).along;
  };
  const double uuu = third(3, 0), uuv = third(2, 1), uvv = third(1, 2), vvv = third(0, 3);
  const double area = base.area, du = base.du, dv = base.dv;
  // |n_u|, |n_v| and |n·N_u|, |n·N_v| over |N|.
  const double turn_u = (uu.along * dv + uv.along * du) / area;
  const double turn_v = (uv.along * dv + vv.along * du) / area;
  const double grow_u = (uu.across * dv + uv.across * du) / area;
  const double grow_v = (uv.across * dv + vv.across * du) / area;
  const double across_uu =
      (uuu * dv + uuv * du + 2 * (uu.along * uv.across + uv.along * uu.across)) / area +
      2 * grow_u * turn_u;
  const double across_uv =
      (uuv * dv + uvv * du + uu.along * vv.across + vv.along * uu.across) / area + grow_u * turn_v +
      grow_v * turn_u;
  const double across_vv =
      (uvv * dv + vvv * du + 2 * (uv.along * vv.across + vv.along * uv.across)) / area +
      2 * grow_v * turn_v;
  const auto moved = [&](SplitBound& s, double along, double across) {
    s.along += offset_mm * (along + base.tilt * across);
    s.across += offset_mm * (across + base.tilt * along);
    s.mapped += offset_mm * (across + base.tilt * along) * b.map.norm();
  };
  moved(b.duu, turn_u * turn_u, across_uu);
  moved(b.duv, turn_u * turn_v, across_uv);
  moved(b.dvv, turn_v * turn_v, across_vv);
  b.bend_u += offset_mm * (across_uu + base.tilt * turn_u * turn_u);
  b.bend_v += offset_mm * (across_vv + base.tilt * turn_v * turn_v);
  const auto change = normal_change(cell, b);
  b.du_moved += change[0] * offset_mm;
  b.dv_moved += change[1] * offset_mm;
  b.proven = std::isfinite(norm(b.duu) + norm(b.duv) + norm(b.dvv));
  return b;
}

}  // namespace limitgauge::engine::surface
