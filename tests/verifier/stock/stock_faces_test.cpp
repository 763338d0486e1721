#include "verifier/stock/stock_faces.h"

#include <cmath>

#include "tests/support/catch.h"
#include "verifier/cutter/removed_space.h"

namespace limitgauge::verifier {
namespace {

using model::Stock;
using model::Vec3;

model::Pose leaning_pose() {
  model::Pose pose = model::turn_about({1, -2, 0.5}, 64);
  pose.shift_mm = {3, 4, -5};
  return pose;
}

}  // namespace

TEST_CASE("faces of a leaning stock are those of the upright one, seen from elsewhere", "[unit]") {
  const model::Pose pose = leaning_pose();
  for (const Stock& upright : {Stock(model::BoxStock{{-3, -2, 1}, {8, 5, 3}}),
                               Stock(model::CylinderStock{{1, -2, 0}, 6, 9})}) {
    const auto own = StockFaces::of(upright), there = StockFaces::of(turned(upright, pose));
    REQUIRE(own);
    REQUIRE(there);
    CHECK(there->count() == own->count());
    for (std::uint32_t face = 0; face < own->count(); ++face) {
      CHECK(there->is_concave(face) == own->is_concave(face));
      for (int k = 0; k < 27; ++k) {
        const Vec3 p{-4.0 + 4 * (k % 3), -3.5 + 3 * (k / 3 % 3), 0.25 + 3 * (k / 9)};
        const BodyDistance here = own->distance(face, p),
                           other = there->distance(face, pose.point(p));
        CHECK(std::abs(here.value - other.value) < 1e-13);
        CHECK(distance(pose.direction(here.gradient), other.gradient) < 1e-14);
      }
    }
  }
}

TEST_CASE("the outside of a leaning bar is what lies round it", "[unit]") {
  // Lying along X from 0 to 10, radius 2.
  const Stock bar =
      turned(Stock(model::CylinderStock{{0, 0, 0}, 4, 10}), model::turn_about({0, 1, 0}, 90));
  const RemovedSpace space(bar, {});
  CHECK(space.stock_distance_mm({5, 0, 0}) == Approx(2));
  CHECK(space.stock_distance_mm({9, 0, 0.5}) == Approx(1));
  CHECK(space.stock_distance_mm({5, 0, 3}) == Approx(-1));
  CHECK(space.stock_distance_mm({-0.5, 0, 0}) == Approx(-0.5));
}

}  // namespace limitgauge::verifier
