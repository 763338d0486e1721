#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace limitgauge::model {

/// The numbers from `low` to `high`, both in; none where low > high. Its arithmetic rounds to the
/// nearest: whoever proves something with it adds what that may lose.
struct Interval {
  double low = 0, high = 0;

  /// Holds nothing, and grows by `add`.
  static constexpr Interval none() {
    return {std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  }
  static constexpr Interval all() {
    return {-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  }

  constexpr bool empty() const { return !(low <= high); }
  constexpr double width() const { return high - low; }
  constexpr void add(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  /// The interval grows to hold `b` as well; an empty one changes nothing.
  constexpr void add(const Interval& b) {
    if (!b.empty()) add(b.low), add(b.high);
  }
  constexpr Interval widened(double by) const { return {low - by, high + by}; }
  /// Of the absolute values.
  double largest() const { return std::max(std::abs(low), std::abs(high)); }
};

constexpr Interval operator+(const Interval& a, const Interval& b) {
  return {a.low + b.low, a.high + b.high};
}
constexpr Interval operator*(double f, const Interval& a) {
  return f >= 0 ? Interval{f * a.low, f * a.high} : Interval{f * a.high, f * a.low};
}
constexpr Interval operator*(const Interval& a, const Interval& b) {
  const double p = a.low * b.low, q = a.low * b.high, r = a.high * b.low, s = a.high * b.high;
  return {std::min({p, q, r, s}), std::max({p, q, r, s})};
}
/// Of the squares, tighter than a * a.
inline Interval square(const Interval& a) {
  const double low = a.low > 0 ? a.low : a.high < 0 ? -a.high : 0, high = a.largest();
  return {low * low, high * high};
}

}  // namespace limitgauge::model
