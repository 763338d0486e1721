#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace limitgauge::model {

/// A point or a direction in the part's frame. Lengths are millimetres unless a name says
/// otherwise.
struct Vec3 {
  double x = 0, y = 0, z = 0;

  constexpr double& operator[](int axis) { return axis == 0 ? x : axis == 1 ? y : z; }
  constexpr double operator[](int axis) const { return axis == 0 ? x : axis == 1 ? y : z; }
  constexpr Vec3& operator+=(const Vec3& b) { return x += b.x, y += b.y, z += b.z, *this; }
  constexpr Vec3& operator-=(const Vec3& b) { return x -= b.x, y -= b.y, z -= b.z, *this; }
  constexpr Vec3& operator*=(double s) { return x *= s, y *= s, z *= s, *this; }
  friend constexpr bool operator==(const Vec3&, const Vec3&) = default;
};

constexpr Vec3 operator+(Vec3 a, const Vec3& b) {
  return a += b;
}
constexpr Vec3 operator-(Vec3 a, const Vec3& b) {
  return a -= b;
}
constexpr Vec3 operator-(const Vec3& a) {
  return {-a.x, -a.y, -a.z};
}
constexpr Vec3 operator*(Vec3 a, double s) {
  return a *= s;
}
constexpr Vec3 operator*(double s, Vec3 a) {
  return a *= s;
}
constexpr Vec3 operator/(const Vec3& a, double s) {
  return {a.x / s, a.y / s, a.z / s};
}

constexpr double dot(const Vec3& a, const Vec3& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
constexpr Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
constexpr double length_squared(const Vec3& a) {
  return dot(a, a);
}
inline double length(const Vec3& a) {
  return std::sqrt(dot(a, a));
}
inline double distance(const Vec3& a, const Vec3& b) {
  return length(a - b);
}
constexpr Vec3 lerp(const Vec3& a, const Vec3& b, double t) {
  return a + (b - a) * t;
}
inline bool is_finite(const Vec3& a) {
  return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z);
}
/// As seen along Z.
inline double level_distance(const Vec3& a, const Vec3& b) {
  return std::hypot(b.x - a.x, b.y - a.y);
}
/// The unit vector along `a`; the zero vector stays zero.
inline Vec3 normalized(const Vec3& a) {
  const double l = length(a);
  return l > 0 ? a / l : a;
}

/// In radians, from 0 to pi; good to rounding for small angles, too. Lengths do not matter.
inline double angle_between(const Vec3& a, const Vec3& b) {
  return std::atan2(length(cross(a, b)), dot(a, b));
}

/// An axis-aligned box; a default one is empty and grows by `add`.
struct Box3 {
  Vec3 low{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(),
           std::numeric_limits<double>::infinity()};
  Vec3 high{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(),
            -std::numeric_limits<double>::infinity()};

  constexpr bool empty() const { return low.x > high.x || low.y > high.y || low.z > high.z; }
  constexpr Vec3 centre() const { return (low + high) * 0.5; }
  constexpr Vec3 size() const { return high - low; }
  constexpr void add(const Vec3& p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  constexpr void add(const Box3& b) {
    if (!b.empty()) add(b.low), add(b.high);
  }
  constexpr Box3 grown(double by_mm) const {
    const Vec3 d{by_mm, by_mm, by_mm};
    return {low - d, high + d};
  }
  constexpr bool contains(const Vec3& p) const {
    return p.x >= low.x && p.y >= low.y && p.z >= low.z && p.x <= high.x && p.y <= high.y &&
           p.z <= high.z;
  }
};

/// Squared distance from `p` to the nearest point of the box, zero inside, in mm².
constexpr double distance_squared(const Box3& b, const Vec3& p) {
  const double dx = std::max({b.low.x - p.x, 0.0, p.x - b.high.x});
  const double dy = std::max({b.low.y - p.y, 0.0, p.y - b.high.y});
  const double dz = std::max({b.low.z - p.z, 0.0, p.z - b.high.z});
  return dx * dx + dy * dy + dz * dz;
}

}  // namespace limitgauge::model
