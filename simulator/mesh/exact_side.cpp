#include "simulator/mesh/exact_side.h"

#include <array>
#include <cmath>

namespace limitgauge::simulator {
namespace {

// A number as an unevaluated sum of two that do not overlap.
struct Pair {
  double high = 0, low = 0;
};

Pair sum_of(double a, double b) {
  const double s = a + b, b_part = s - a, a_part = s - b_part;
  return {s, (a - a_part) + (b - b_part)};
}

Pair product_of(double a, double b) {
  const double p = a * b;
  return {p, std::fma(a, b, -p)};
}

int sign_of(double x) {
  return (x > 0) - (x < 0);
}

// An exact sum: components of growing size that do not overlap, so that the last one that is not
// zero has the sign of all.
class ExactSum {
 public:
  void add(double x) {
    for (int i = 0; i < count_; ++i) {
      const Pair s = sum_of(x, parts_[i]);
      parts_[i] = s.low, x = s.high;
    }
    parts_[count_++] = x;
  }
  void add(const Pair& p) { add(p.low), add(p.high); }
  int sign() const {
    for (int i = count_ - 1; i >= 0; --i)
      if (parts_[i] != 0) return sign_of(parts_[i]);
    return 0;
  }

 private:
  static constexpr int kMostParts = 12;
  std::array<double, kMostParts> parts_{};
  int count_ = 0;
};

int side_from_coordinates(const FlatPoint& a, const FlatPoint& b, const FlatPoint& p) {
  ExactSum sum;
  sum.add(product_of(b.x, p.y)), sum.add(product_of(-b.x, a.y));
  sum.add(product_of(-a.x, p.y)), sum.add(product_of(-b.y, p.x));
  sum.add(product_of(b.y, a.x)), sum.add(product_of(a.y, p.x));
  return sum.sign();
}

}  // namespace

int side_of_line(const FlatPoint& a, const FlatPoint& b, const FlatPoint& p) {
  const Pair bx = sum_of(b.x, -a.x), by = sum_of(b.y, -a.y);
  const Pair px = sum_of(p.x, -a.x), py = sum_of(p.y, -a.y);
  const double left = bx.high * py.high, right = by.high * px.high, det = left - right;
  constexpr double kFilter = 3.3306690738754716e-16;  // (3 + 16 u) u with u = 2^-53
  if (std::abs(det) > kFilter * (std::abs(left) + std::abs(right))) return sign_of(det);
  // Coordinates on a lattice have exact differences as a rule.
  if (bx.low != 0 || by.low != 0 || px.low != 0 || py.low != 0)
    return side_from_coordinates(a, b, p);
  const Pair l = product_of(bx.high, py.high), r = product_of(by.high, px.high);
  return l.high != r.high ? sign_of(l.high - r.high) : sign_of(l.low - r.low);
}

}  // namespace limitgauge::simulator
