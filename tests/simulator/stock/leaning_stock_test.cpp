// Blocks and bars that lean: the same solids as upright ones seen from another frame.
#include <cmath>
#include <random>

#include "simulator/instrument/dexel_grid.h"
#include "simulator/stock/raw_stock.h"
#include "tests/support/catch.h"

namespace limitgauge::simulator {
namespace {

using model::BoxStock;
using model::CylinderStock;
using model::Pose;
using model::Stock;
using model::Vec3;

const BoxStock kBlock{{-3, -2, 1}, {8, 5, 3}};
const CylinderStock kBar{{1, -2, 0.5}, 6, 9};

Vec3 drawn(std::mt19937& random, double reach) {
  std::uniform_real_distribution<double> in(-reach, reach);
  const double x = in(random), y = in(random);
  return {x, y, in(random)};
}

Pose drawn_pose(std::mt19937& random) {
  Pose pose = model::turn_about(drawn(random, 1), 90 + 85 * drawn(random, 1).x);
  pose.shift_mm = drawn(random, 20);
  return pose;
}

/// Ends of the material on the vertical are where the distance is nil, and between them is
/// material.
void check_line(const RawStock& raw, double x, double y) {
  const auto intervals = raw_on_line(raw, x, y);
  REQUIRE(intervals.size() <= 1);
  const model::Box3& box = raw.box();
  for (double z = box.low.z - 1; z < box.high.z + 1; z += 0.05) {
    const double d = raw.distance({x, y, z}).distance;
    if (std::abs(d) < 1e-9) continue;
    const bool held = !intervals.empty() && intervals[0].low < z && z < intervals[0].high;
    CHECK(held == (d < 0));
  }
  for (const model::Interval& t : intervals) {
    CHECK(std::abs(raw.distance({x, y, t.low}).distance) < 1e-9);
    CHECK(std::abs(raw.distance({x, y, t.high}).distance) < 1e-9);
  }
}

}  // namespace

TEST_CASE("a leaning stock has the distances of the upright one", "[unit][setups]") {
  std::mt19937 random(5);
  for (int k = 0; k < 40; ++k) {
    const Stock upright = k % 2 ? Stock(kBlock) : Stock(kBar);
    const Pose pose = drawn_pose(random);
    const Stock there = turned(upright, pose);
    REQUIRE(std::holds_alternative<model::LeaningStock>(there));
    const RawStock own(upright), other(there);
    CHECK(other.convex());
    CHECK(other.surface_area_mm2() == own.surface_area_mm2());
    for (int i = 0; i < 50; ++i) {
      const Vec3 p = drawn(random, 12);
      const RawSample here = own.distance(p), turned_on = other.distance(pose.point(p));
      CHECK(std::abs(here.distance - turned_on.distance) < 1e-12);
      CHECK(distance(pose.direction(here.gradient), turned_on.gradient) < 1e-12);
      if (here.distance < 0) CHECK(other.box().contains(pose.point(p)));
    }
  }
}

TEST_CASE("a leaning stock's box touches it on every side", "[unit][setups]") {
  std::mt19937 random(6);
  for (int k = 0; k < 20; ++k) {
    const RawStock raw(turned(k % 2 ? Stock(kBlock) : Stock(kBar), drawn_pose(random)));
    const model::Box3& box = raw.box();
    // The box is tight: a plane of its side a hair further in cuts the stock somewhere.
    for (const int a : {0, 1, 2})
      for (const bool high : {false, true}) {
        const Vec3 middle = (box.low + box.high) * 0.5;
        Vec3 way;
        way[a] = high ? 1 : -1;
        // The supporting point: far out along the axis, its foot on a convex body.
        const Vec3 far = middle + way * 1e5;
        const RawSample s = raw.distance(far);
        const Vec3 foot = far - s.gradient * s.distance;
        CHECK(std::abs(foot[a] - (high ? box.high[a] : box.low[a])) < 1e-2);
      }
  }
}

TEST_CASE("lines through leaning stock end where it ends", "[unit][setups]") {
  std::mt19937 random(7);
  for (int k = 0; k < 24; ++k) {
    const RawStock raw(turned(k % 2 ? Stock(kBlock) : Stock(kBar), drawn_pose(random)));
    const Vec3 middle = (raw.box().low + raw.box().high) * 0.5;
    for (int i = 0; i < 6; ++i) {
      const Vec3 aside = drawn(random, 5);
      check_line(raw, middle.x + aside.x, middle.y + aside.y);
    }
  }
  // Lying along X, a line beside it, one along its rim's height, and one straight through its end.
  const RawStock lying(
      turned(Stock(CylinderStock{{0, 0, 0}, 4, 10}), model::turn_about({0, 1, 0}, 90)));
  CHECK(raw_on_line(lying, 5, 2.5).empty());
  CHECK(raw_on_line(lying, 11, 0).empty());
  REQUIRE(raw_on_line(lying, 5, 0).size() == 1);
  CHECK(raw_on_line(lying, 5, 0)[0].low == Approx(-2));
  CHECK(raw_on_line(lying, 5, 0)[0].high == Approx(2));
}

TEST_CASE("turned back, a leaning stock stands again", "[unit][setups]") {
  const Pose pose = model::turn_about({0, 1, 0}, 90);
  const Stock there = turned(turned(Stock(kBar), pose), pose);
  // Half a turn about Y: end for end.
  CHECK(std::get<CylinderStock>(there).base_mm == Vec3{-1, -2, -9.5});
}

}  // namespace limitgauge::simulator
