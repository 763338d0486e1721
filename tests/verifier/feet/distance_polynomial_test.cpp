#include "verifier/feet/distance_polynomial.h"

#include <random>

#include "tests/support/catch.h"

namespace limitgauge::verifier {

using model::Vec3;

// What the proof rests on: the coefficients bound half the squared distance and its second
// derivatives, in a window as in the whole.
TEST_CASE("the distance polynomial bounds the distance and its Hessian", "[property]") {
  std::mt19937 random(17);
  std::uniform_real_distribution<double> off(-3, 3), part(0, 1);
  for (int n = 0; n < 100; ++n) {
    Bezier b;
    for (int k = 0; k < 16; ++k)
      b.set(k, {3.0 * (k % 4) + off(random), 3.0 * (k / 4) + off(random), off(random)});
    const Vec3 p{4 + off(random), 4 + off(random), 3 * off(random)};
    const double at = 0.1 + 0.8 * part(random);
    const DistancePolynomial f =
        split_v(split_u(distance_polynomial(b, p), at)[n % 2], 0.5)[n / 2 % 2];
    const HessianRange h = hessian_range(f);
    const double size_u = n % 2 == 0 ? at : 1 - at;
    for (int m = 0; m < 50; ++m) {
      const double u = (n % 2 == 0 ? 0 : at) + size_u * part(random),
                   v = (n / 2 % 2 + part(random)) / 2;
      const BezierJet j = jet(b, u, v);
      const Vec3 r = j.position - p;
      // Rounding of values below 1e4.
      const double slack = 1e-9;
      CHECK(f.low() <= length_squared(r) / 2 + slack);
      const double uu = (dot(j.du, j.du) + dot(r, j.duu)) * size_u * size_u,
                   uv = (dot(j.du, j.dv) + dot(r, j.duv)) * size_u / 2,
                   vv = (dot(j.dv, j.dv) + dot(r, j.dvv)) / 4;
      CHECK((h.uu_low <= uu + slack && uu <= h.uu_high + slack));
      CHECK((h.uv_low <= uv + slack && uv <= h.uv_high + slack));
      CHECK((h.vv_low <= vv + slack && vv <= h.vv_high + slack));
    }
  }
}

}  // namespace limitgauge::verifier
