#include "verifier/cells/derivative_hull.h"

#include <algorithm>
#include <cmath>

namespace limitgauge::verifier {
namespace {

using model::Box3;
using model::Vec3;

/// Holds f·x + g·y for every x of one box and y of the other.
Box3 mixed(double f, const Box3& a, double g, const Box3& b) {
  const Vec3 c = a.centre() * f + b.centre() * g,
             h = (a.size() * std::abs(f) + b.size() * std::abs(g)) * 0.5;
  return {c - h, c + h};
}

}  // namespace

model::Interval along(const Box3& box, const Vec3& d) {
  const Vec3 c = box.centre(), h = box.size() * 0.5;
  const double at = dot(c, d);
  const double by = h.x * std::abs(d.x) + h.y * std::abs(d.y) + h.z * std::abs(d.z);
  return {at - by, at + by};
}

double longest(const Box3& box) {
  const auto far = [](double a, double b) { return std::max(std::abs(a), std::abs(b)); };
  return length(
      Vec3{far(box.low.x, box.high.x), far(box.low.y, box.high.y), far(box.low.z, box.high.z)});
}

DerivativeHull derivative_hull(const SurfaceCell& cell) {
  DerivativeHull h;
  const Bezier& b = cell.shape;
  const auto at = [&](int i, int j) { return b.control(4 * j + i); };
  const double u = 1 / cell.size_u, v = 1 / cell.size_v;
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 4; ++i) {
      if (i < 3) h.u.add((at(i + 1, j) - at(i, j)) * (3 * u));
      if (j < 3) h.v.add((at(i, j + 1) - at(i, j)) * (3 * v));
      if (i < 2) h.uu.add((at(i + 2, j) - at(i + 1, j) * 2 + at(i, j)) * (6 * u * u));
      if (j < 2) h.vv.add((at(i, j + 2) - at(i, j + 1) * 2 + at(i, j)) * (6 * v * v));
      if (i < 3 && j < 3)
        h.uv.add((at(i + 1, j + 1) - at(i + 1, j) - at(i, j + 1) + at(i, j)) * (9 * u * v));
    }
  return h;
}

std::optional<PlaneParameters> PlaneParameters::of(const SurfaceCell& cell) {
  PlaneParameters f;
  const BezierJet j = jet(cell.shape, 0.5, 0.5);
  const Vec3 along_u = j.du / cell.size_u, along_v = j.dv / cell.size_v;
  f.along_u_mm = length(along_u), f.along_v_mm = length(along_v);
  f.u_x = 1 / f.along_u_mm;
  const double skew = dot(along_v, along_u) * f.u_x * f.u_x;
  const Vec3 across = along_v - along_u * skew;
  f.v_y = 1 / length(across);
  f.u_y = -skew * f.v_y;
  if (!std::isfinite(f.u_x) || !std::isfinite(f.v_y)) return std::nullopt;
  f.t = along_u * f.u_x, f.b = across * f.v_y;
  return f;
}

DerivativeHull PlaneParameters::taken(const DerivativeHull& h) const {
  DerivativeHull out;
  out.u = mixed(u_x, h.u, 0, h.v), out.v = mixed(u_y, h.u, v_y, h.v);
  out.uu = mixed(u_x * u_x, h.uu, 0, h.uv), out.uv = mixed(u_x * u_y, h.uu, u_x * v_y, h.uv);
  out.vv = mixed(1, mixed(u_y * u_y, h.uu, 2 * u_y * v_y, h.uv), v_y * v_y, h.vv);
  return out;
}

}  // namespace limitgauge::verifier
