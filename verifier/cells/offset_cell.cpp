#include "verifier/cells/offset_cell.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "verifier/cells/normal_cone.h"
#include "verifier/tolerance.h"

namespace limitgauge::verifier {
namespace {

using model::Vec3;

/// Of a polynomial of degree `kDegree` in u and v with Bézier coefficients c: the plane
/// at + by_u·(u − 1/2) + by_v·(v − 1/2), and how far from it each component goes at most.
struct Plane {
  Vec3 at, by_u, by_v;
  Vec3 apart;
};

template <int kDegree, class Coefficient>
Plane plane_of(Coefficient&& c) {
  constexpr int kLast = kDegree;
  const Vec3 c00 = c(0, 0), c10 = c(kLast, 0), c01 = c(0, kLast), c11 = c(kLast, kLast);
  Plane p;
  p.by_u = ((c10 - c00) + (c11 - c01)) / 2;
  p.by_v = ((c01 - c00) + (c11 - c10)) / 2;
  Vec3 low = c00, high = c00;
  bool first = true;
  const auto rest = [&](int i, int j) {
    return c(i, j) - p.by_u * (double(i) / kLast - 0.5) - p.by_v * (double(j) / kLast - 0.5);
  };
  for (int j = 0; j <= kLast; ++j)
    for (int i = 0; i <= kLast; ++i) {
      const Vec3 r = rest(i, j);
      if (first) low = high = r, first = false;
      for (int k = 0; k < 3; ++k)
        low[k] = std::min(low[k], r[k]), high[k] = std::max(high[k], r[k]);
    }
  p.at = (low + high) / 2;
  p.apart = (high - low) / 2;
  return p;
}

/// A with A·s_u = n_u and A·s_v = n_v in the plane across n₀, and A·n₀ = 0.
std::array<Vec3, 3> map_of(const Vec3& n, Vec3 s_u, Vec3 s_v, const Vec3& n_u, const Vec3& n_v) {
  s_u = s_u - n * dot(n, s_u), s_v = s_v - n * dot(n, s_v);
  const double det = dot(n, cross(s_u, s_v));
  if (!(std::abs(det) > 0)) return {};
  // The dual basis of s_u, s_v in the tangent plane.
  const Vec3 d_u = cross(s_v, n) / det, d_v = cross(n, s_u) / det;
  std::array<Vec3, 3> columns{};
  for (int k = 0; k < 3; ++k) columns[k] = n_u * d_u[k] + n_v * d_v[k];
  return columns;
}

double norm_of(const std::array<Vec3, 3>& a) {
  return std::sqrt(length_squared(a[0]) + length_squared(a[1]) + length_squared(a[2]));
}

double chord_of(double angle_rad) {
  return 2 * std::sin(std::min(angle_rad, std::numbers::pi) / 2);
}

/// The coefficients of S_u × S_v of a cell with n₀ as third axis.
struct NormalsInFrame {
  Vec3 axes[3];
  std::array<Vec3, 36> c;
  double least = std::numeric_limits<double>::infinity();  ///< along n₀

  NormalsInFrame(const std::array<Vec3, 36>& coefficients, const Vec3& n) {
    axes[0] = across(-n), axes[1] = cross(n, axes[0]), axes[2] = n;
    for (int k = 0; k < 36; ++k) {
      c[k] = {dot(coefficients[k], axes[0]), dot(coefficients[k], axes[1]),
              dot(coefficients[k], axes[2])};
      least = std::min(least, c[k].z);
    }
  }
  /// Of a vector in the frame, the part across n₀ in space.
  Vec3 aside(const Vec3& v) const { return axes[0] * v.x + axes[1] * v.y; }
};

/// How far n(s) can be from L = n₀ + A·(s − m), by the planes of the normals' polynomial and of S:
/// with N⊥ and N∥ the parts of S_u × S_v across n₀ and along it, n = cos θ·(n₀ + N⊥/N∥), so that
/// |n − L| ≤ |N⊥ − N∥·A·(s − m)|/N∥ + (1/cos θ − 1).
double remainder_of(const OffsetCell& cell, const NormalsInFrame& frame, const Plane& normals,
                    const Plane& points) {
  const double size = normals.at.z, least = frame.least / size;
  if (!(least > 0) || !(std::cos(cell.spread_rad) > 0.25)) return 2;
  double most_turned = 0;
  for (int k = 0; k < 16; ++k) {
    const Vec3 w = cell.shape.control(k) - cell.middle;
    most_turned = std::max(most_turned, length(cell.turned(w)));
  }
  const Vec3 l_u = cell.turned(points.by_u), l_v = cell.turned(points.by_v);
  const double off =
      norm_of(cell.turning) * length(points.apart) + length(cell.turned(points.at - cell.middle));
  const auto aside = [&](const Vec3& v) { return frame.aside(v) / size; };
  const double constant = length(aside(normals.at));
  const double linear = (length(aside(normals.by_u) - l_u) + length(aside(normals.by_v) - l_v)) / 2;
  const double growth = (std::abs(normals.by_u.z) + std::abs(normals.by_v.z)) / size;
  const double quadratic = growth * (length(l_u) + length(l_v)) / 4;
  const double apart = std::hypot(normals.apart.x, normals.apart.y) / size;
  const double error = constant + linear + quadratic + apart + (1 + growth / 2) * off +
                       normals.apart.z / size * most_turned;
  return std::min(2.0, error / least + (1 / std::cos(cell.spread_rad) - 1));
}

}  // namespace

Bezier OffsetCell::moved(double t_mm) const {
  Bezier out = shape;
  for (int k = 0; k < 16; ++k) {
    const double x = shape.x[k] - middle.x, y = shape.y[k] - middle.y, z = shape.z[k] - middle.z;
    const double side = (k / 4) * (2.0 / 3) - 1;
    out.x[k] += t_mm * (normal.x + turning[0].x * x + turning[1].x * y + turning[2].x * z);
    out.y[k] += t_mm * (normal.y + turning[0].y * x + turning[1].y * y + turning[2].y * z);
    out.z[k] += t_mm * (normal.z + turning[0].z * x + turning[1].z * y + turning[2].z * z);
    out.x[k] += t_mm * side * fan.x, out.y[k] += t_mm * side * fan.y;
    out.z[k] += t_mm * side * fan.z;
  }
  return out;
}

OffsetCell offset_cell(const Bezier& cell, const Vec3& normal, double spread_rad) {
  return {cell, middle(cell), normal, {}, {}, chord_of(spread_rad), spread_rad};
}

/// With axes n₀, f along the fan and g across both, a normal is (1, y, z)/√(1 + y² + z²) with y and
/// z between those of `normals`: |y| ≤ η, |z| ≤ ζ. It is no further from (1, y, 0) than
/// √(1 + η² + ζ²) − 1 + ζ.
OffsetCell offset_cell(const Bezier& cell, const Vec3& normal, const Vec3& from, const Vec3& to,
                       std::span<const Vec3> normals) {
  double spread = 0;
  for (const Vec3& c : normals) spread = std::max(spread, angle_between(c, normal));
  const OffsetCell round = offset_cell(cell, normal, spread);
  const Vec3 way = to - from, across = way - normal * dot(way, normal);
  if (!(length(across) > 0) || !(std::cos(spread) > 0)) return round;
  const Vec3 f = normalized(across), g = cross(normal, f);
  double along = 0, aside = 0;
  for (const Vec3& c : normals) {
    const double up = dot(c, normal);
    along = std::max(along, std::abs(dot(c, f)) / up);
    aside = std::max(aside, std::abs(dot(c, g)) / up);
  }
  OffsetCell out = round;
  out.fan = f * along;
  out.remainder = std::hypot(1.0, along, aside) - 1 + aside + kUnitRounding;
  return out.remainder < round.remainder ? out : round;
}

OffsetCell offset_cell(const Bezier& cell, const Vec3& vertex_normal) {
  OffsetCell out{cell, middle(cell), vertex_normal, {}, {}, 0, 0};
  if (length(vertex_normal) > 0) return out;
  if (control_radius(cell, out.middle) <= kPoint_mm) {
    out.remainder = 1, out.spread_rad = std::numbers::pi;
    return out;
  }
  const BezierJet at = jet(cell, 0.5, 0.5);
  const Vec3 across = cross(at.du, at.dv);
  if (length_squared(across) > 0) out.normal = normalized(across);
  const std::array<Vec3, 36> c = normal_coefficients(cell);
  const auto spread = normal_spread_rad(c, out.normal);
  out.spread_rad = spread.value_or(std::numbers::pi);
  out.remainder = chord_of(out.spread_rad);
  if (!spread) return out;
  const NormalsInFrame frame(c, out.normal);
  const Plane normals = plane_of<5>([&](int i, int j) { return frame.c[6 * j + i]; });
  const double size = normals.at.z;
  if (!(size > 0)) return out;
  const Plane points = plane_of<3>([&](int i, int j) { return cell.control(4 * j + i); });
  OffsetCell turned = out;
  turned.turning = map_of(out.normal, points.by_u, points.by_v, frame.aside(normals.by_u) / size,
                          frame.aside(normals.by_v) / size);
  turned.remainder = remainder_of(turned, frame, normals, points);
  return turned.remainder < out.remainder ? turned : out;
}

OffsetCell turned(OffsetCell cell, const model::Pose& pose) {
  cell.shape = turned(cell.shape, pose);
  cell.middle = pose.point(cell.middle);
  cell.normal = pose.direction(cell.normal);
  cell.fan = pose.direction(cell.fan);
  // R·A·Rᵀ: the columns of A·Rᵀ, turned.
  const std::array<model::Vec3, 3> a = cell.turning;
  for (int k = 0; k < 3; ++k) {
    const model::Vec3& back = pose.rows[k];
    cell.turning[k] = pose.direction(a[0] * back.x + a[1] * back.y + a[2] * back.z);
  }
  return cell;
}

}  // namespace limitgauge::verifier
