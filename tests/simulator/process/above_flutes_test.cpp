#include "simulator/sweep/cutter_profile.h"
#include "tests/simulator/process/process_bench.h"
#include "tests/support/catch.h"

namespace {

using namespace limitgauge;
using namespace limitgauge::simulator::test;
using model::CutterType;
using simulator::FindingKind;
using simulator::Pass;

}  // namespace

TEST_CASE("material above the flutes within the cutter's radius", "[unit][process]") {
  const auto c = flat4(5);
  CHECK(check(block(), slot(c, 4.99)).empty());
  const auto all = check(block(), slot(c, 7));
  REQUIRE(all.size() == 1);
  CHECK(all[0].kind == FindingKind::below_flutes);
  CHECK(all[0].part == "cutter");
  // A ledge 2 mm high over the slot: its middle is 1 mm from top and bottom.
  CHECK(all[0].depth_mm == Approx(1).margin(kTolerance));
  CHECK(all[0].point.z == Approx(-1).margin(2 * kTolerance));
  // In two levels nothing stands above the flutes.
  const Pass levels = PathBuilder({-20, 0, -4})
                          .feed({20, 0, -4})
                          .rapid({20, 0, 5})
                          .rapid({-20, 0, 5})
                          .rapid({-20, 0, -7})
                          .feed({20, 0, -7})
                          .pass(c);
  CHECK(check(block(), levels).empty());
}

TEST_CASE("a taper that plunges deeper than its flutes meets nothing with them",
          "[unit][process]") {
  // What is above the flutes slides along the hole's wall, which their top's rim has made.
  auto c = cutter(CutterType::taper, 3, 3, 0, 8);
  const Pass hole = PathBuilder({0, 0, 5}).feed({0, 0, -5}).rapid({0, 0, 5}).pass(c);
  CHECK(check(block(), hole).empty());
  CHECK(check(block(), split(hole, 3)).empty());
  // A shank that is wider than the top by 0.2 mm stands in the wall.
  c.shank = {{2 * simulator::CutterProfile(c).largest_radius() + 0.4, 20}};
  const auto wider = check(block(), PathBuilder({0, 0, 5}).feed({0, 0, -5}).pass(c));
  CHECK(worst_of(wider, FindingKind::shank_in_stock) == Approx(0.2).margin(kTolerance));
}

TEST_CASE("a part above the flutes as wide as they are speaks for itself", "[unit][process]") {
  auto c = flat4(5);
  c.shank = {{4, 20}};
  auto all = check(block(), slot(c, 7));
  REQUIRE(all.size() == 1);
  CHECK(all[0].kind == FindingKind::shank_in_stock);
  // A neck that ploughs through what the flutes have left above them.
  c.shank = {{3, 20}};
  all = check(block(), slot(c, 7));
  REQUIRE(all.size() == 1);
  CHECK(all[0].kind == FindingKind::below_flutes);
  CHECK(all[0].part == "shank");
  // A neck, then a holder that is too low as well.
  c.shank = {{3, 1}};
  c.holder = {{10, 20}};
  all = check(block(), slot(c, 7));
  REQUIRE(all.size() == 2);
  CHECK(all[0].kind == FindingKind::holder_in_stock);
  CHECK(all[1].kind == FindingKind::below_flutes);
}

TEST_CASE("a shank wider than its slot", "[unit][process]") {
  auto c = flat4(3);
  c.shank = {{6, 20}};
  const auto all = check(block(), PathBuilder({-20, 0, -6}).feed({0, 0, -6}).pass(c));
  REQUIRE(all.size() == 1);
  CHECK(all[0].kind == FindingKind::shank_in_stock);
  CHECK(all[0].part == "shank");
  // On the shank's side at radius 3 the depth is the smaller of −z and the distance to the slot's
  // rim at radius 2, z = −3: both are 5/3 at z = −5/3.
  CHECK(all[0].depth_mm == Approx(5.0 / 3).margin(kTolerance));
  CHECK(all[0].point.z == Approx(-5.0 / 3).margin(0.05));
  c.shank = {{4, 20}};
  CHECK(check(block(), PathBuilder({0, 0, 2}).feed({0, 0, -2.9}).rapid({0, 0, 5}).pass(c)).empty());
}

TEST_CASE("a holder that dips into the stock", "[unit][process]") {
  auto c = flat4(7);
  c.holder = {{10, 4}, {14, 10}};
  CHECK(check(block(), slot(c, 6.99)).empty());
  const auto all = check(block(), slot(c, 7.75));
  REQUIRE(all.size() == 1);
  CHECK(all[0].kind == FindingKind::holder_in_stock);
  CHECK(all[0].depth_mm == Approx(0.75).margin(kTolerance));
}

TEST_CASE("a neck may stand under a ledge that it does not touch", "[unit][process]") {
  // A slot 4 wide in levels, and at its floor aside, under its wall.
  auto c = flat4(1.25);
  c.shank = {{2, 20}};
  const auto undercut = [&](double aside_mm) {
    PathBuilder path({-20, 0, 5});
    for (double z = -1; z >= -3; z -= 1)
      path.rapid({-20, 0, 5}).rapid({-20, 0, z}).feed({20, 0, z}).rapid({20, 0, 5});
    return path.rapid({-20, 0, 5})
        .rapid({-20, aside_mm, 5})
        .rapid({-20, aside_mm, -3})
        .feed({20, aside_mm, -3})
        .pass(c);
  };
  // The neck comes to 1.9 from the slot's middle, whose wall is at 2; then 0.3 beyond it.
  CHECK(check(block(), undercut(0.9)).empty());
  const auto all = check(block(), undercut(1.3));
  REQUIRE(all.size() == 1);
  CHECK(all[0].kind == FindingKind::below_flutes);
  CHECK(all[0].depth_mm == Approx(0.3).margin(kTolerance));
  // Levels as high as the flutes only just meet.
  c.flute_length_mm = 1;
  CHECK(check(block(), undercut(0.9)).empty());
  // Where nobody says that there is a neck, there is none. The ledge is 1.75 high.
  c.flute_length_mm = 1.25;
  c.shank = {};
  CHECK(worst_of(check(block(), undercut(0.9)), FindingKind::below_flutes) ==
        Approx(0.875).margin(kTolerance));
}

TEST_CASE("a part over a neck meets the ledge that it comes down on", "[unit][process]") {
  auto c = flat4(1.25);
  c.shank = {{2, 1}, {3.6, 20}};
  const auto down_to = [&](double z) {
    return PathBuilder({-20, 0, -1})
        .feed({20, 0, -1})
        .rapid({20, 0, 5})
        .rapid({-20, 0, 5})
        .rapid({-20, 0, -2})
        .feed({20, 0, -2})
        .rapid({20, 0.9, 5})
        .rapid({20, 0.9, -2})
        .feed({0, 0.9, -2})
        .feed({0, 0.9, z})
        .pass(c);
  };
  CHECK(check(block(), down_to(-2.25)).empty());
  // The wider part comes 0.75 below the top, its side 0.7 beyond the slot's wall.
  const auto all = check(block(), down_to(-3));
  REQUIRE(all.size() == 1);
  CHECK(all[0].kind == FindingKind::below_flutes);
  CHECK(all[0].depth_mm == Approx(0.375).margin(kTolerance));
}
