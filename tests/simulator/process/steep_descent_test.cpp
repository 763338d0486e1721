#include <cmath>
#include <numbers>

#include "tests/simulator/process/process_bench.h"
#include "tests/support/catch.h"

namespace {

using namespace limitgauge;
using namespace limitgauge::simulator::test;
using simulator::FindingKind;
using simulator::Pass;

}  // namespace

TEST_CASE("stairs are as steep as the way down them", "[unit][process]") {
  auto c = flat4();
  c.steepest_descent_deg = 5;
  // Every step is shallower than the tolerance and has a micrometre of level way.
  const auto stairs = [&](double step_mm, double level_mm) {
    PathBuilder path({0, 0, 0.005});
    for (int i = 1; i * step_mm < 0.15; ++i) {
      path.feed({i % 2 ? 0.0 : level_mm, 0, 0.005 - i * step_mm});
      path.feed({i % 2 ? level_mm : 0.0, 0, 0.005 - i * step_mm});
    }
    return path.pass(c);
  };
  CHECK(worst_of(check(block(), stairs(0.0095, 0.001)), FindingKind::steep_descent) ==
        Approx(0.15).margin(0.03));
  // Layers of it are none: each is cut level over more than the descent would take at 5 degrees.
  CHECK(count_of(check(block(), stairs(0.0095, 0.5)), FindingKind::steep_descent) == 0);
}

TEST_CASE("what a ramp has cut is no descent for what comes down on it", "[unit][process]") {
  auto c = flat4();
  c.steepest_descent_deg = 5;
  // A steep approach in air, a ramp of 4 degrees there and back, then links that lift off and come
  // back down onto ground that is cut, a millimetre on each time.
  PathBuilder path({-5, 0, 15});
  path.feed({-5, 0, 0.1});
  double z = 0.1;
  for (int i = 0; i < 3; ++i) {
    path.feed({5, 0, z - 0.65}).feed({-5, 0, z - 1.3});
    z -= 1.3;
  }
  path.feed({5, 0, z});
  for (int i = 0; i < 6; ++i) {
    const double x = 5 - i;
    path.feed({x, 0, z + 0.5}).feed({x - 1, 0, z + 0.5}).feed({x - 1, 0, z}).feed({x - 1, 1, z});
    path.feed({x - 1, 0, z});
  }
  CHECK(count_of(check(block(), path.pass(c)), FindingKind::steep_descent) == 0);
}

TEST_CASE("a descent steeper than the cutter can", "[unit][process]") {
  auto c = flat4();
  c.steepest_descent_deg = 5;
  const auto ramp = [&](double degrees) {
    const double drop = 20 * std::tan(degrees * std::numbers::pi / 180);
    return PathBuilder({-10, 0, 0}).feed({10, 0, -drop}).feed({-10, 0, -drop}).pass(c);
  };
  CHECK(check(block(), ramp(5)).empty());
  const auto all = check(block(), ramp(6));
  REQUIRE(all.size() == 1);
  CHECK(all[0].kind == FindingKind::steep_descent);
  CHECK(all[0].line == 1);
  // The flat's edge ends 20·tan 6° below the top, less where the cutter was before.
  CHECK(all[0].depth_mm == Approx(20 * std::tan(6 * std::numbers::pi / 180)).margin(kTolerance));
  // In pieces, each of which shaves off less than the tolerance.
  CHECK(worst_of(check(block(), split(ramp(6), 300)), FindingKind::steep_descent) ==
        Approx(all[0].depth_mm).margin(kTolerance));
  CHECK(check(block(), split(ramp(5), 300)).empty());
}

TEST_CASE("a plunge needs a cutter that can or a hole", "[unit][process]") {
  auto c = flat4();
  const auto plunge = [&] {
    return PathBuilder({0, 0, 5}).feed({0, 0, -3}).rapid({0, 0, 5}).pass(c);
  };
  CHECK(check(block(), plunge()).empty());
  const Pass bore = plunge();
  c.steepest_descent_deg = 30;
  const auto all = check(block(), plunge());
  REQUIRE(all.size() == 1);
  CHECK(all[0].kind == FindingKind::steep_descent);
  CHECK(all[0].depth_mm == Approx(3).margin(kTolerance));
  CHECK(check(block().cut(bore, {2}), plunge()).empty());
  // Beside the stock, touching it.
  const Pass beside = PathBuilder({-17, 0, 5}).feed({-17, 0, -3}).pass(c);
  CHECK(check(block(), beside).empty());
}
