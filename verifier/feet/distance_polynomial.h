#pragma once

#include <array>

#include "verifier/surface/bezier.h"

namespace limitgauge::verifier {

/// Half the squared distance from a point to a Bézier patch over [0, 1]², in Bernstein form of
/// degree (6, 6): coefficient (i, j) stands at index 7·j + i, i along u. The polynomial and its
/// derivatives lie between the least and the greatest of their coefficients, so these bound it over
/// the whole of a window, and more closely with the square of the window's size.
struct DistancePolynomial {
  std::array<double, 49> c{};

  double low() const;
};
DistancePolynomial distance_polynomial(const Bezier& b, const model::Vec3& p);
/// The parts over [0, at] and [at, 1] in u, or in v.
std::array<DistancePolynomial, 2> split_u(const DistancePolynomial& f, double at);
std::array<DistancePolynomial, 2> split_v(const DistancePolynomial& f, double at);

/// Least and greatest of the second derivatives over the window.
struct HessianRange {
  double uu_low = 0, uu_high = 0, uv_low = 0, uv_high = 0, vv_low = 0, vv_high = 0;
};
HessianRange hessian_range(const DistancePolynomial& f);

}  // namespace limitgauge::verifier
