#pragma once

#include <cmath>

namespace limitgauge::model {

/// A point or a direction in a plane. Lengths are millimetres unless a name says otherwise.
struct Vec2 {
  double x = 0, y = 0;

  constexpr double& operator[](int axis) { return axis == 0 ? x : y; }
  constexpr double operator[](int axis) const { return axis == 0 ? x : y; }
  friend constexpr bool operator==(const Vec2&, const Vec2&) = default;
};

constexpr Vec2 operator+(const Vec2& a, const Vec2& b) {
  return {a.x + b.x, a.y + b.y};
}
constexpr Vec2 operator-(const Vec2& a, const Vec2& b) {
  return {a.x - b.x, a.y - b.y};
}
constexpr Vec2 operator*(const Vec2& a, double s) {
  return {a.x * s, a.y * s};
}
constexpr Vec2 operator*(double s, const Vec2& a) {
  return a * s;
}
constexpr Vec2 operator/(const Vec2& a, double s) {
  return {a.x / s, a.y / s};
}

constexpr double dot(const Vec2& a, const Vec2& b) {
  return a.x * b.x + a.y * b.y;
}
/// Twice the area of the triangle from the origin; above zero where `b` is counter-clockwise of
/// `a`.
constexpr double cross(const Vec2& a, const Vec2& b) {
  return a.x * b.y - a.y * b.x;
}
constexpr double length_squared(const Vec2& a) {
  return dot(a, a);
}
inline double length(const Vec2& a) {
  return std::hypot(a.x, a.y);
}
inline double distance(const Vec2& a, const Vec2& b) {
  return length(a - b);
}
constexpr Vec2 lerp(const Vec2& a, const Vec2& b, double t) {
  return a + (b - a) * t;
}
/// Turned by 90 degrees counter-clockwise.
constexpr Vec2 quarter_turn(const Vec2& a) {
  return {-a.y, a.x};
}

}  // namespace limitgauge::model
