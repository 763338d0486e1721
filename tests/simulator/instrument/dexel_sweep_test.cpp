#include "simulator/instrument/dexel_sweep.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "tests/simulator/instrument/dexel_cutters.h"
#include "tests/simulator/instrument/dexel_oracle.h"
#include "tests/support/catch.h"

namespace {

using namespace limitgauge;
using model::Vec3;
using simulator::DexelProfile;
using simulator::DexelSweep;
using simulator::test::DexelOracle;
using simulator::test::every_cutter;

/// A move out of all kinds: sloped, level, vertical, none, steep, along an axis.
Vec3 target(std::mt19937_64& random, const Vec3& from, int kind) {
  std::uniform_real_distribution<> d(-4, 4);
  const Vec3 delta{d(random), d(random), d(random)};
  switch (kind) {
    case 0:
      return from + Vec3{delta.x, delta.y, 0};
    case 1:
      return from + Vec3{0, 0, delta.z};
    case 2:
      return from;
    case 3:
      return from + Vec3{1e-3 * delta.x, 1e-3 * delta.y, delta.z};
    case 4:
      return from + Vec3{0, delta.y, 0.2 * delta.z};
    default:
      return from + delta;
  }
}

}  // namespace

// Outside the swept solid the oracle's value is at most the distance and inside it is minus a
// depth: along a line both ends of the part inside are its only zeroes, so that these three places
// pin the interval. Golden section finds a least value to 1e-12 where it is smooth and to the
// square root of rounding, times a slope of at most 1, in no case less.
TEST_CASE("the interval of a move on a line ends where a brute-force sweep does",
          "[property][dexel]") {
  std::mt19937_64 random(71);
  std::uniform_real_distribution<> place(-5, 5), share(0, 1), off(-3, 3);
  std::size_t hit = 0, missed = 0;
  for (const model::Cutter& cutter : every_cutter()) {
    const DexelProfile profile(cutter);
    const DexelOracle oracle(cutter);
    CHECK(profile.largest_radius() == Approx(oracle.largest_radius()).epsilon(1e-12));
    for (int i = 0; i < 2000; ++i) {
      const Vec3 from{place(random), place(random), place(random)};
      const Vec3 to = target(random, from, i % 8);
      const Vec3 near = lerp(from, to, share(random));
      const Vec3 line{near.x + off(random), near.y + off(random), 0};
      const auto found = DexelSweep(profile, from, to).interval(line.x, line.y);
      const Vec3 d = to - from, foot{from.x, from.y, 0};
      const double run2 = d.x * d.x + d.y * d.y;
      const double t =
          run2 > 0 ? std::clamp(dot(line - foot, Vec3{d.x, d.y, 0}) / run2, 0.0, 1.0) : 0.0;
      const double apart = model::level_distance(lerp(from, to, t), line);
      if (!found) {
        ++missed;
        REQUIRE(apart >= oracle.largest_radius() - 1e-12);
        continue;
      }
      ++hit;
      INFO(model::to_text(cutter) << " move kind " << i % 8);
      REQUIRE(apart <= oracle.largest_radius() + 1e-12);
      REQUIRE(found->low <= found->high);
      const auto value = [&](double z) { return oracle.swept(from, to, {line.x, line.y, z}); };
      REQUIRE(std::abs(value(found->low)) < 2e-9);
      REQUIRE(std::abs(value(found->high)) < 2e-9);
      if (found->high - found->low > 1e-3) REQUIRE(value((found->low + found->high) / 2) < 0);
    }
  }
  CHECK(hit > 10000);
  CHECK(missed > 1000);
}

TEST_CASE("the lower ends on a row are those of the single lines", "[property][dexel]") {
  std::mt19937_64 random(72);
  std::uniform_real_distribution<> place(-5, 5);
  const std::vector<double> standing(40, 1e9);
  std::vector<double> low(40);
  for (const model::Cutter& cutter : every_cutter()) {
    const DexelProfile profile(cutter);
    for (int i = 0; i < 300; ++i) {
      const Vec3 from{place(random), place(random), place(random)};
      const DexelSweep sweep(profile, from, target(random, from, i % 8));
      const double y = place(random);
      sweep.lower_ends(-5, y, 0.25, 40, standing.data(), low.data());
      const auto wide = sweep.span(y - 0.5, y + 0.5);
      for (int k = 0; k < 40; ++k) {
        const double x = -5 + k * 0.25;
        const auto one = sweep.interval(x, y);
        REQUIRE(one.has_value() == std::isfinite(low[static_cast<std::size_t>(k)]));
        if (!one) continue;
        // The same formula along another order of operations; near the rim of a ball, where it
        // stands upright, the root of their rounding.
        REQUIRE(low[static_cast<std::size_t>(k)] == Approx(one->low).margin(1e-7));
        REQUIRE(sweep.least_upper() <= one->high + 1e-12);
        REQUIRE((wide.low <= x + 1e-12 && x <= wide.high + 1e-12));
      }
    }
  }
}

TEST_CASE("dexel intervals of simple moves are those of their formulas", "[unit][dexel]") {
  const auto cutters = every_cutter();
  const DexelProfile flat(cutters[0]), ball(cutters[1]);
  const double r = ball.largest_radius(), length = cutters[1].flute_length_mm;
  // A ball going down along x by 45 degrees, over a line in its middle: the capsule's underside.
  const DexelSweep ramp(ball, {0, 0, 0}, {10, 0, -10});
  CHECK(ramp.interval(5, 0)->low == Approx(-5 + r - r * std::sqrt(2.0)).margin(1e-12));
  CHECK(ramp.interval(5, 0)->high == Approx(-5 + r + length).margin(1e-12));
  // A flat going up: its rim trails behind.
  const double half = flat.largest_radius();
  const DexelSweep climb(flat, {0, 0, 0}, {10, 0, 5});
  CHECK(climb.interval(5, 0)->low == Approx(0.5 * (5 - half)).margin(1e-12));
  CHECK_FALSE(climb.interval(5, half + 1e-9).has_value());
  CHECK(climb.interval(-half, 0)->low == Approx(0).margin(1e-12));
}
