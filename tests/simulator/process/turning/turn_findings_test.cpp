#include "simulator/process/turning/turn_check.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "tests/simulator/process/turning/turn_bench.h"
#include "tests/support/catch.h"

namespace {

using namespace limitgauge;
using namespace limitgauge::simulator::test;
using model::CutterType;
using model::Vec3;
using simulator::Finding;
using simulator::FindingKind;
using simulator::ProcessLimits;
using simulator::TurningPose;
using simulator::TurningTool;

constexpr double kNearTurn = 0.5;

// The rim of a flat of radius 2 is lowest where it passes under the pivot, 50 above the block.
double lowest_rim(double arm_mm) {
  return std::hypot(arm_mm, 2.0) - 50;
}

void check_depth(const Finding& f, FindingKind kind, double depth_mm) {
  CHECK(f.kind == kind);
  CHECK(f.depth_mm <= depth_mm + 1e-9);
  CHECK(f.depth_mm >= depth_mm - kTolerance);
}

void check_distance(const Finding& f, double left_mm) {
  CHECK(f.kind == FindingKind::near_miss);
  CHECK(-f.depth_mm >= left_mm - 1e-9);
  CHECK(-f.depth_mm <= left_mm + kTolerance);
}

ProcessLimits limits_with(const model::TriangleMesh& mesh, double near_miss_mm = 0) {
  ProcessLimits limits = plain_limits(near_miss_mm);
  limits.fixtures = {fixture("trunnion", mesh)};
  return limits;
}

}  // namespace

TEST_CASE("a flat that swings through the block is found at its lowest", "[unit][turn]") {
  for (const double arm : {50.02, 50.5, 52.0}) {
    INFO("arm " << arm);
    const auto all = turn_findings(block(), flat4(), rapid_turn(pendulum(arm).pose()));
    REQUIRE(all.size() == 1);
    check_depth(all[0], FindingKind::rapid_through_stock, lowest_rim(arm));
    CHECK(all[0].line == 7);
    CHECK(all[0].part == "cutter");
    CHECK(all[0].against == "stock");
    CHECK(all[0].point.z == Approx(-lowest_rim(arm)).margin(2 * kTolerance));
    CHECK(std::hypot(all[0].point.x, all[0].point.y) < 2);
  }
}

TEST_CASE("flutes that meet material at a feed rate cut while turning", "[unit][turn]") {
  const auto all = turn_findings(block(), flat4(), feed_turn(pendulum(51).pose()));
  REQUIRE(all.size() == 1);
  check_depth(all[0], FindingKind::cut_while_turning, lowest_rim(51));
}

TEST_CASE("a swing that stays over the block touches nothing and is a near miss", "[unit][turn]") {
  for (const double arm : {49.9, 49.8, 49.6}) {
    const TurningTool motion = rapid_turn(pendulum(arm).pose());
    CHECK(turn_findings(block(), flat4(), motion).empty());
    const auto near = turn_findings(block(), flat4(), motion, plain_limits(kNearTurn));
    REQUIRE(near.size() == 1);
    check_distance(near[0], -lowest_rim(arm));
    CHECK(near[0].point.z == Approx(0).margin(kTolerance));
  }
  const TurningTool high = rapid_turn(pendulum(49.4).pose());
  CHECK(turn_findings(block(), flat4(), high, plain_limits(kNearTurn)).empty());
}

TEST_CASE("contacts within the tolerance are slight, and sliding is none", "[unit][turn]") {
  // The arm whose rim comes as deep as asked for.
  const auto to_depth = [](double depth) {
    return rapid_turn(pendulum(std::sqrt((50 + depth) * (50 + depth) - 4)).pose());
  };
  const auto slight = turn_findings(block(), flat4(), to_depth(0.6 * kTolerance));
  REQUIRE(slight.size() == 1);
  check_depth(slight[0], FindingKind::slight_contact, 0.6 * kTolerance);
  CHECK(turn_findings(block(), flat4(), to_depth(0.05 * kTolerance)).empty());
  const auto deep = turn_findings(block(), flat4(), to_depth(1.6 * kTolerance));
  REQUIRE(deep.size() == 1);
  CHECK(deep[0].kind == FindingKind::rapid_through_stock);
}

TEST_CASE("a holder that hits in the middle of its arc only is found", "[unit][turn]") {
  auto c = flat4();
  c.shank = {{3, 10}};
  c.holder = {{30, 10}, {40, 10}};
  // The tool lies level in the middle of the block's height and goes round about its tip.
  const simulator::test::Swing level{
      shifted({0, -60, -4}) * model::turn_about({0, 1, 0}, 90), {0, -60, -4}, {0, 0, 1}, -80, 260};
  const auto all = turn_findings(block(), c, rapid_turn(level.pose()), plain_limits(kNearTurn));
  REQUIRE(all.size() == 1);
  check_depth(all[0], FindingKind::holder_in_stock, std::hypot(50, 20) - 50);
  CHECK(all[0].part == "holder");
  CHECK(all[0].point.y == Approx(std::hypot(50, 20) - 60).margin(0.1));
}

TEST_CASE("parts have findings of their own", "[unit][turn]") {
  auto c = flat4(1);
  c.shank = {{5, 2}};
  c.holder = {{9, 20}};
  // 5 mm deep in the block, upright, through its middle.
  const TurningPose along = TurningPose::even(
      [](double t) {
        return shifted({80 * t - 40, 0, -5});
      },
      80, 0);
  const auto all = turn_findings(block(), c, feed_turn(along), plain_limits(kNearTurn));
  REQUIRE(all.size() == 3);
  CHECK(all[0].kind == FindingKind::cut_while_turning);
  CHECK(all[1].kind == FindingKind::shank_in_stock);
  CHECK(all[2].kind == FindingKind::holder_in_stock);
  // The block is 8 high: the middle of it is 4 deep, and the shank reaches from 4 down to 2.
  CHECK(all[1].depth_mm == Approx(4).margin(kTolerance));
  CHECK(all[2].depth_mm == Approx(2).margin(kTolerance));
}

TEST_CASE("a ball that turns about its own middle stays as near as it is", "[unit][turn]") {
  const auto c = cutter(CutterType::ball, 10, 30);
  const auto turn = [](double over) {
    return simulator::test::Swing{shifted({0, 0, over}), {0, 0, over + 5}, {0.6, 0.8, 0}, -40, 40}
        .pose();
  };
  const auto deep = turn_findings(block(), c, rapid_turn(turn(-0.2)));
  REQUIRE(deep.size() == 1);
  check_depth(deep[0], FindingKind::rapid_through_stock, 0.2);
  CHECK(turn_findings(block(), c, rapid_turn(turn(0)), plain_limits(kNearTurn)).empty());
  // What stands still is the affair of the moves before and after; not so beside a fixture.
  CHECK(turn_findings(block(), c, rapid_turn(turn(0.3)), plain_limits(kNearTurn)).empty());
  TurningTool motion = rapid_turn(parked());
  motion.in_fixtures = {turn(0.3)};
  const auto near =
      turn_findings(block(), c, motion, limits_with(box_mesh({{-15, -10, -8}, {15, 10, 0}}), 0.5));
  REQUIRE(near.size() == 1);
  check_distance(near[0], 0.3);
}

TEST_CASE("a tool that leaves where it has just cut touches nothing", "[unit][turn]") {
  const auto c = GENERATE(flat4(), ball4());
  const auto cut = block().cut(PathBuilder({-20, 0, -3}).feed({2, 0, -3}).pass(c), {2});
  const TurningPose away = TurningPose::even(
      [](double t) {
        return shifted({2, 0, 30 * t - 3}) * model::turn_about({0, 1, 0}, -20 * t);
      },
      30, 20 * 3.1416 / 180);
  CHECK(turn_findings(cut, c, feed_turn(away)).empty());
  // The same way turned much faster than it goes up digs the rim, or the side, in.
  const TurningPose dug = TurningPose::even(
      [](double t) {
        return shifted({2, 0, t - 3}) * model::turn_about({0, 1, 0}, 60 * t);
      },
      1, 60 * 3.1416 / 180);
  const auto all = turn_findings(cut, c, feed_turn(dug), plain_limits(kNearTurn));
  REQUIRE(all.size() == 1);
  CHECK(all[0].kind == FindingKind::cut_while_turning);
}

TEST_CASE("fixtures go with axes of their own", "[unit][turn]") {
  // The tool hangs still, and a box turns about Y below it: as the pendulum, seen from the box.
  TurningTool motion = rapid_turn(TurningPose::even(
      [](double) {
        return shifted({3, 4, 500});
      },
      0, 0));
  const ProcessLimits limits = limits_with(box_mesh({{-15, -10, -8}, {15, 10, 0}}), kNearTurn);
  motion.in_fixtures = {pendulum(51).pose()};
  const auto hit = turn_findings(block(), flat4(), motion, limits);
  REQUIRE(hit.size() == 1);
  check_depth(hit[0], FindingKind::fixture_touched, lowest_rim(51));
  CHECK(hit[0].against == "trunnion");
  // Told where the tool is: on its rim.
  CHECK(hit[0].point.z == Approx(500).margin(0.2));
  CHECK(std::hypot(hit[0].point.x - 3, hit[0].point.y - 4) == Approx(2).margin(0.2));
  motion.in_fixtures = {pendulum(49.7).pose()};
  const auto near = turn_findings(block(), flat4(), motion, limits);
  REQUIRE(near.size() == 1);
  check_distance(near[0], -lowest_rim(49.7));
}

TEST_CASE("findings of a turn are the same for any number of threads", "[unit][turn]") {
  auto c = ball4();
  c.holder = {{20, 30}};
  TurningTool motion = rapid_turn(
      simulator::test::Swing{shifted({1, 2, -2}), {3, 0, 6}, {0.3, 0.9, 0.1}, -70, 80}.pose());
  motion.in_fixtures = {pendulum(50.4).pose()};
  const ProcessLimits limits = limits_with(box_mesh({{-15, -10, -8}, {15, 10, 0}}), kNearTurn);
  const auto one = turn_findings(slotted_block(), c, motion, limits, 1);
  REQUIRE(one.size() >= 2);
  for (const unsigned threads : {2u, 5u}) {
    const auto other = turn_findings(slotted_block(), c, motion, limits, threads);
    CHECK(std::equal(one.begin(), one.end(), other.begin(), other.end(),
                     [](const Finding& a, const Finding& b) {
                       return a.kind == b.kind && a.part == b.part && a.against == b.against &&
                              a.point == b.point && a.depth_mm == b.depth_mm;
                     }));
  }
}

TEST_CASE("turns that cannot be are refused", "[unit][turn]") {
  const auto refused = [](const TurningTool& motion, const ProcessLimits& limits) {
    CHECK_THROWS_AS(turn_findings(block(), flat4(), motion, limits), std::invalid_argument);
  };
  TurningTool motion = rapid_turn(pendulum(40).pose());
  CHECK_NOTHROW(turn_findings(block(), flat4(), motion));
  refused(motion, limits_with(box_mesh({{0, 0, 0}, {1, 1, 1}})));  // a fixture without a pose
  ProcessLimits none = plain_limits();
  none.tolerance_mm = 0;
  refused(motion, none);
  // Bounds that the pose breaks: of the tip, of the turn, of how they bend.
  for (double TurningPose::*bound : {&TurningPose::tip_speed_mm, &TurningPose::turn_rad,
                                     &TurningPose::tip_bend_mm, &TurningPose::turn_bend_rad}) {
    TurningTool slow = motion;
    slow.in_stock.*bound *= 0.3;
    refused(slow, plain_limits());
  }
}
