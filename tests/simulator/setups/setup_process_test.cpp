// A process after the part was turned over: what it runs into is what earlier setups left.
#include <cmath>
#include <stdexcept>

#include "tests/simulator/process/process_bench.h"
#include "tests/simulator/setups/turned_bench.h"
#include "tests/support/catch.h"

namespace {

using namespace limitgauge;
using model::Pose;
using simulator::FindingKind;
using simulator::Pass;
using simulator::StockModel;
using namespace simulator::test;

/// Bottom up, with the new top at z = 0 again.
Pose bottom_up() {
  Pose pose = model::turn_about({1, 0, 0}, 180);
  pose.shift_mm = {0, 0, -8};
  return pose;
}

/// From above: a slot along x, 4 mm wide, to a floor at `z`.
Pass slot_from_above(double z) {
  return PathBuilder({-20, 0, 5}).feed({-20, 0, z}).feed({20, 0, z}).feed({20, 0, 5}).pass(flat4());
}

/// Bottom up: down by rapid to `z` and along the slot.
Pass rapid_from_below(double y, double z) {
  return PathBuilder({-5, y, 5})
      .rapid({-5, y, z})
      .rapid({5, y, z})
      .rapid({5, y, 5})
      .pass(cutter(model::CutterType::flat, 3, 20));
}

StockModel turned_over(const Pass& from_above) {
  return StockModel(turned(setup_block(), bottom_up()), 0.25, kSetupBytes)
      .cut(placed(from_above, bottom_up()), {2});
}

}  // namespace

TEST_CASE("a rapid through what the setup before left is found", "[unit][setups]") {
  // 3 mm are left under the slot: the deepest place is in the middle of them.
  const auto found = of_kind(check(turned_over(slot_from_above(-5)), rapid_from_below(0, -2)),
                             FindingKind::rapid_through_stock);
  REQUIRE_FALSE(found.empty());
  double deepest = 0;
  for (const auto& f : found) deepest = std::max(deepest, f.depth_mm);
  CHECK(deepest == Approx(1.5).margin(2 * kTolerance));
}

TEST_CASE("a rapid through what the setup before removed is none", "[unit][setups]") {
  const StockModel through = turned_over(slot_from_above(-9));
  CHECK(of_kind(check(through, rapid_from_below(0, -6)), FindingKind::rapid_through_stock).empty());
  // Beside the slot it is one, and 0.3 mm into its wall.
  CHECK_FALSE(
      of_kind(check(through, rapid_from_below(0.8, -6)), FindingKind::rapid_through_stock).empty());
}

TEST_CASE("above the floor of the setup before there is room down to it", "[unit][setups]") {
  // Cut open from above, all but 3 mm; from below, a rapid in what is left after a feed.
  const StockModel half_open = turned_over(slot_from_above(-5));
  const Pass opens = PathBuilder({-5, 0, 5})
                         .feed({-5, 0, -3.5})
                         .feed({5, 0, -3.5})
                         .rapid({5, 0, -7})
                         .rapid({-5, 0, -7})
                         .pass(cutter(model::CutterType::flat, 3, 20));
  CHECK(of_kind(check(half_open, opens), FindingKind::rapid_through_stock).empty());
}

TEST_CASE("a process is checked in its own setup", "[unit][setups]") {
  const StockModel stock = turned_over(slot_from_above(-5));
  CHECK_THROWS_AS(check(stock, placed(slot_from_above(-5), bottom_up())), std::invalid_argument);
}
