// The certificate allows 1e-9 mm for rounding (certificate.h). Here the distances that it rests on
// are computed again in extended precision, at coordinates as large as the allowance is stated for.
#include <random>

#include "tests/support/catch.h"
#include "verifier/certificate/certificate.h"
#include "verifier/cutter/swept_body.h"

namespace limitgauge::verifier {
namespace {

using model::Vec3;
using Real = long double;

struct Point {
  Real x, y, z;
};

/// The open profile distance, with 64 bits of mantissa.
Real profile(const CutterProfile& c, Real rho, Real height) {
  const Real h = height - c.rounding_mm, beyond = rho - c.flat_mm;
  const Real steep = std::sqrt(1 + Real(c.slope) * c.slope);
  const Real along = (beyond * c.slope + h) / steep, wall = (beyond - h * c.slope) / steep;
  if (wall <= 0 && h >= 0) return std::max(wall, -h) - c.rounding_mm;
  if (beyond <= 0 && h < 0) return -h - c.rounding_mm;
  if (along >= 0) return wall - c.rounding_mm;
  return std::sqrt(beyond * beyond + h * h) - c.rounding_mm;
}

Real at(const CutterProfile& c, const SweptBody& body, const Point& p, Real t) {
  const Real x = p.x - (body.from.x + t * (Real(body.to.x) - body.from.x));
  const Real y = p.y - (body.from.y + t * (Real(body.to.y) - body.from.y));
  const Real z = p.z - (body.from.z + t * (Real(body.to.z) - body.from.z));
  return profile(c, std::sqrt(x * x + y * y), z);
}

/// Golden section on the convex function of the position along the move.
Real swept(const CutterProfile& c, const SweptBody& body, const Point& p) {
  const Real golden = (std::sqrt(Real(5)) - 1) / 2;
  Real low = 0, high = 1;
  for (int n = 0; n < 120; ++n) {
    const Real a = high - golden * (high - low), b = low + golden * (high - low);
    if (at(c, body, p, a) <= at(c, body, p, b))
      high = b;
    else
      low = a;
  }
  return std::min({at(c, body, p, (low + high) / 2), at(c, body, p, 0), at(c, body, p, 1)});
}

}  // namespace

TEST_CASE("rounding of distances is far below what the certificate allows for it", "[property]") {
  const model::Cutter cutters[] = {{"ball", model::CutterType::ball, 6, 3, 0, 60, {}, {}},
                                   {"flat", model::CutterType::flat, 8, 0, 0, 60, {}, {}},
                                   {"bull", model::CutterType::bull, 10, 2, 0, 60, {}, {}},
                                   {"taper", model::CutterType::taper, 2, 0.5, 8, 60, {}, {}}};
  std::mt19937 random(31);
  std::uniform_real_distribution<double> place(-9900, 9900), part(-15, 15);
  double worst = 0, worst_plane = 0;
  for (const model::Cutter& cutter : cutters) {
    const CutterProfile c(cutter);
    for (int n = 0; n < 1500; ++n) {
      const Vec3 origin{place(random), place(random), place(random)};
      const auto near = [&] { return origin + Vec3{part(random), part(random), part(random)}; };
      const Vec3 a = near();
      Vec3 b = near();
      if (n % 3 == 1) b.z = a.z;
      if (n % 3 == 2) b.x = a.x, b.y = a.y;
      const SweptBody body(a, b);
      const Vec3 p = near(), q = near();
      const BodyDistance d = body_distance(c, body, p);
      const double exact = static_cast<double>(swept(c, body, {p.x, p.y, p.z}));
      worst = std::max(worst, std::abs(d.value - exact) - d.slack_mm);
      // The supporting plane, taken over to another point, must not exceed the distance there.
      const double plane = d.value + dot(d.gradient, q - p) - d.slack_mm;
      worst_plane =
          std::max(worst_plane, plane - static_cast<double>(swept(c, body, {q.x, q.y, q.z})));
    }
  }
  constexpr double kPicometre_mm = 1e-9, kAllowed_mm = kRounding_mm - kOmitted_mm;
  CHECK(worst / kPicometre_mm < 0.1 * kAllowed_mm / kPicometre_mm);
  CHECK(worst_plane / kPicometre_mm < 0.1 * kAllowed_mm / kPicometre_mm);
}

}  // namespace limitgauge::verifier
