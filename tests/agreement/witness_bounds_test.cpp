// What the witness allows for: rounding of coordinates and of sharpness.
#include <cmath>

#include "tests/support/cages.h"
#include "tests/support/catch.h"
#include "tests/support/feature_cages.h"
#include "verifier/surface/reference_surface.h"
#include "witness/bounds.h"
#include "witness/limit_points.h"

namespace limitgauge {
namespace {

using witness::bounds_of;
using witness::in_single_precision;

model::Cage creased(double sharpness) {
  model::Cage cage = tests::cube_cage();
  cage.creases = {{{4, 5}, sharpness}, {{5, 7}, sharpness}};
  return cage;
}

/// Worst distance of the reference surface from the witness's, in mm.
double worst_mm(const model::Cage& cage) {
  const verifier::ReferenceSurface surface(cage);
  double worst = 0;
  for (const auto& p : witness::limit_points(cage, {3, 100'000}).points)
    worst = std::max(worst, distance(surface.evaluate(p.patch, p.u, p.v).position, p.position));
  return worst;
}

}  // namespace

TEST_CASE("a sharpness below ten stays below ten in single precision", "[unit][witness]") {
  CHECK(in_single_precision(2.5) == 2.5F);
  CHECK(in_single_precision(10) == 10.0F);
  CHECK(in_single_precision(1e300) == 10.0F);
  CHECK(static_cast<float>(9.99999999) == 10.0F);
  CHECK(in_single_precision(9.99999999) < 10.0F);
  CHECK(in_single_precision(9.99999999) == Approx(10).epsilon(1e-6));
}

TEST_CASE("sharpness that single precision holds adds nothing to the bound", "[unit][witness]") {
  for (const double s : {0.0, 0.5, 2.25, 10.0, 12.3})
    CHECK(bounds_of(creased(s), 10).sharpness_mm == 0);
  CHECK(bounds_of(creased(2.3), 10).sharpness_mm > 1e-9);
  CHECK(bounds_of(creased(2.3), 10).sharpness_mm < 1e-6);
}

TEST_CASE("rounding grows with the coordinates, not with the part", "[unit][witness]") {
  model::Cage far = tests::cube_cage();
  const double here = bounds_of(far, 10).rounding_mm;
  for (model::Vec3& v : far.vertices) v.x += 1000;
  CHECK(bounds_of(far, 10).rounding_mm > 100 * here);
  CHECK(worst_mm(far) <= bounds_of(far, 10).rounding_mm);
}

TEST_CASE("what single precision does to a sharpness is within its bound, and felt",
          "[property][witness]") {
  for (const double s : {0.1, 0.7, 1.3, 2.3, 3.9}) {
    const model::Cage cage = creased(s);
    CAPTURE(s);
    const double worst = worst_mm(cage);
    CHECK(worst <= bounds_of(cage, 20).position_mm());
    CHECK(worst > bounds_of(cage, 20).rounding_mm);  // a bound of rounding alone would be too low
  }
}

}  // namespace limitgauge
