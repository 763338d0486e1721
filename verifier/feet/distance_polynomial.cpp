#include "verifier/feet/distance_polynomial.h"

#include <algorithm>

#include "model/geometry/interval.h"

namespace limitgauge::verifier {
namespace {

using model::Interval;

constexpr double kChoose3[] = {1, 3, 3, 1}, kChoose6[] = {1, 6, 15, 20, 15, 6, 1};
constexpr int kSide = 7;

/// Weight of the product of control points k and l in the coefficient that their indices add up to.
constexpr std::array<double, 256> product_weights() {
  std::array<double, 256> w{};
  for (int k = 0; k < 16; ++k)
    for (int l = 0; l < 16; ++l) {
      const int i = k % 4, j = k / 4, m = l % 4, n = l / 4;
      w[16 * k + l] =
          kChoose3[i] * kChoose3[m] / kChoose6[i + m] * kChoose3[j] * kChoose3[n] / kChoose6[j + n];
    }
  return w;
}
constexpr std::array<double, 256> kWeights = product_weights();

template <int kStride>
std::array<DistancePolynomial, 2> split(const DistancePolynomial& f, double at) {
  constexpr int kAcross = kStride == 1 ? kSide : 1;
  std::array<DistancePolynomial, 2> out{f, f};
  for (int line = 0; line < kSide; ++line) {
    double* low = out[0].c.data() + line * kAcross;
    double* high = out[1].c.data() + line * kAcross;
    // De Casteljau in place: `high` holds the level, its first entry goes to `low`.
    for (int level = 1; level < kSide; ++level) {
      for (int k = 0; k < kSide - level; ++k)
        high[k * kStride] += (high[(k + 1) * kStride] - high[k * kStride]) * at;
      low[level * kStride] = high[0];
    }
  }
  return out;
}

template <int kStride>
Interval second_differences(const std::array<double, 49>& c) {
  constexpr int kAcross = kStride == 1 ? kSide : 1;
  Interval range = Interval::none();
  for (int line = 0; line < kSide; ++line)
    for (int k = 0; k + 2 < kSide; ++k) {
      const double* at = c.data() + line * kAcross + k * kStride;
      range.add(30 * (at[0] - 2 * at[kStride] + at[2 * kStride]));
    }
  return range;
}

}  // namespace

double DistancePolynomial::low() const {
  return *std::min_element(c.begin(), c.end());
}

DistancePolynomial distance_polynomial(const Bezier& b, const model::Vec3& p) {
  std::array<double, 16> x, y, z;
  for (int k = 0; k < 16; ++k) x[k] = b.x[k] - p.x, y[k] = b.y[k] - p.y, z[k] = b.z[k] - p.z;
  DistancePolynomial f;
  for (int k = 0; k < 16; ++k)
    for (int j = 0; j < 4; ++j)
      for (int i = 0; i < 4; ++i) {
        const int l = 4 * j + i;
        f.c[kSide * (k / 4 + j) + k % 4 + i] +=
            kWeights[16 * k + l] * (x[k] * x[l] + y[k] * y[l] + z[k] * z[l]);
      }
  for (double& v : f.c) v /= 2;
  return f;
}

std::array<DistancePolynomial, 2> split_u(const DistancePolynomial& f, double at) {
  return split<1>(f, at);
}
std::array<DistancePolynomial, 2> split_v(const DistancePolynomial& f, double at) {
  return split<kSide>(f, at);
}

HessianRange hessian_range(const DistancePolynomial& f) {
  const Interval uu = second_differences<1>(f.c), vv = second_differences<kSide>(f.c);
  Interval uv = Interval::none();
  for (int j = 0; j + 1 < kSide; ++j)
    for (int i = 0; i + 1 < kSide; ++i) {
      const double* at = f.c.data() + kSide * j + i;
      uv.add(36 * (at[0] - at[1] - at[kSide] + at[kSide + 1]));
    }
  return {uu.low, uu.high, uv.low, uv.high, vv.low, vv.high};
}

}  // namespace limitgauge::verifier
