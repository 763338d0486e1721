#include "verifier/offset_cell.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "verifier/normal_cone.h"

namespace limitgauge::verifier {
namespace {

using model::Vec3;

/// What is smaller is one point, but for rounding.
constexpr double kPoint_mm = 1e-12;

/// Of a polynomial of degree `kDegree` in u and v with Bézier coefficients c: the plane
/// at + by_u·(u − 1/2) + by_v·(v − 1/2), and how far from it the polynomial goes at most.
struct Plane {
  Vec3 at, by_u, by_v;
  double apart = 0;
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
  p.apart = length(high - low) / 2;
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

/// asin for bounds: a right angle and more where the sine says nothing.
double angle_of(double sine) {
  return sine < 1 ? std::asin(sine) : std::numbers::pi;
}

/// How far n(s) can be from n₀ + A·(s − m), by the planes of the normals' polynomial and of S.
double remainder_of(const OffsetCell& cell, const Plane& normals, const Plane& points) {
  const double size = length(normals.at), norm = norm_of(cell.turning);
  const double radius = control_radius(cell.shape, cell.middle);
  const Vec3 n = cell.normal;
  const auto turned = [&](const Vec3& by) {
    return cell.turning[0] * by.x + cell.turning[1] * by.y + cell.turning[2] * by.z;
  };
  // N and L = n₀ + A·(s − m) as planes in u and v, with |N − plane| ≤ normals.apart and
  // |L − plane| ≤ off.
  const Vec3 l_u = turned(points.by_u), l_v = turned(points.by_v);
  const double off = norm * points.apart + length(turned(points.at - cell.middle));
  const Vec3 m_u = normals.by_u / size, m_v = normals.by_v / size;
  const Vec3 m_0 = normals.at / size;
  // The cross product of the two planes: constant, linear and quadratic terms.
  const double constant = length(cross(m_0, n));
  const double linear =
      (length(cross(m_0, l_u) + cross(m_u, n)) + length(cross(m_0, l_v) + cross(m_v, n))) / 2;
  const double quadratic = (length(m_u) + length(m_v)) * (length(l_u) + length(l_v)) / 4;
  const double least_m = 1 - (length(m_u) + length(m_v)) / 2, apart = normals.apart / size;
  const double least_l = 1 - (length(l_u) + length(l_v)) / 2;
  if (!(least_m - apart > 0.25) || !(least_l - off > 0.25)) return 2;
  const double between = angle_of((constant + linear + quadratic) / (least_m * least_l));
  const double angle = angle_of(apart / least_m) + between + angle_of(off / least_l);
  // A maps into the plane across n₀, so |L|² = 1 + |A·(s − m)|².
  const double longer = norm * radius * norm * radius / 2;
  return std::min(2.0, chord_of(angle) + longer);
}

}  // namespace

Bezier OffsetCell::moved(double t_mm) const {
  Bezier out = shape;
  for (int k = 0; k < 16; ++k) {
    const double x = shape.x[k] - middle.x, y = shape.y[k] - middle.y, z = shape.z[k] - middle.z;
    out.x[k] += t_mm * (normal.x + turning[0].x * x + turning[1].x * y + turning[2].x * z);
    out.y[k] += t_mm * (normal.y + turning[0].y * x + turning[1].y * y + turning[2].y * z);
    out.z[k] += t_mm * (normal.z + turning[0].z * x + turning[1].z * y + turning[2].z * z);
  }
  return out;
}

OffsetCell offset_cell(const Bezier& cell, const Vec3& normal, double spread_rad) {
  return {cell, middle(cell), normal, {}, chord_of(spread_rad), spread_rad};
}

OffsetCell offset_cell(const Bezier& cell, const Vec3& vertex_normal) {
  OffsetCell out{cell, middle(cell), vertex_normal, {}, 0, 0};
  if (length(vertex_normal) > 0) return out;
  if (control_radius(cell, out.middle) <= kPoint_mm) {
    out.remainder = 1, out.spread_rad = std::numbers::pi;
    return out;
  }
  const BezierJet at = jet(cell, 0.5, 0.5);
  const Vec3 across = cross(at.du, at.dv);
  if (length_squared(across) > 0) out.normal = normalized(across);
  const std::array<Vec3, 36> c = normal_coefficients(cell);
  const auto cone = cone_round(c, out.normal);
  out.spread_rad = cone ? cone->half_angle_rad : std::numbers::pi;
  out.remainder = chord_of(out.spread_rad);
  const Plane normals = plane_of<5>([&](int i, int j) { return c[6 * j + i]; });
  const double size = length(normals.at);
  if (!cone || !(size > 0)) return out;
  const Plane points = plane_of<3>([&](int i, int j) { return cell.control(4 * j + i); });
  const auto aside = [&](const Vec3& v) { return (v - out.normal * dot(out.normal, v)) / size; };
  OffsetCell turned = out;
  turned.turning =
      map_of(out.normal, points.by_u, points.by_v, aside(normals.by_u), aside(normals.by_v));
  turned.remainder = remainder_of(turned, normals, points);
  return turned.remainder < out.remainder ? turned : out;
}

}  // namespace limitgauge::verifier
