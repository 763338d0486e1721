#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "simulator/process/gap_search.h"
#include "simulator/stock/material.h"
#include "tests/simulator/process/process_bench.h"
#include "tests/support/catch.h"

namespace {

using namespace limitgauge;
using namespace limitgauge::simulator::test;
using model::CutterType;
using model::Vec3;
using simulator::Finding;
using simulator::FindingKind;
using simulator::Pass;
using simulator::StockModel;

constexpr double kNear = 0.5;

std::vector<Finding> check_near(const StockModel& before, const Pass& pass) {
  return check(before, pass, plain_limits(kNear));
}

// What is promised: never too small, at most a tolerance too large.
void check_left(const Finding& f, double left) {
  CHECK(f.kind == FindingKind::near_miss);
  CHECK(-f.depth_mm >= left - 1e-9);
  CHECK(-f.depth_mm <= left + kTolerance);
}

}  // namespace

TEST_CASE("a rapid that passes close over the stock", "[unit][nearmiss]") {
  const auto c = GENERATE(flat4(), ball4(), cutter(CutterType::bull, 4, 20, 1));
  const auto over = [&](double z) { return PathBuilder({-20, 0, z}).rapid({20, 2, z}).pass(c); };
  for (const double left : {0.05, 0.2, 0.45}) {
    const auto all = check_near(block(), over(left));
    REQUIRE(all.size() == 1);
    check_left(all[0], left);
    CHECK(all[0].part == "cutter");
    CHECK(all[0].against == "stock");
    CHECK(all[0].point.z == Approx(0).margin(kTolerance));
  }
  CHECK(check_near(block(), over(kNear + 2 * kTolerance)).empty());
  // Sliding is none, and what touches is another finding.
  CHECK(check_near(block(), over(0)).empty());
  const auto through = check_near(block(), over(-0.2));
  REQUIRE(through.size() == 1);
  CHECK(through[0].kind == FindingKind::rapid_through_stock);
}

TEST_CASE("a rapid that passes close beside a wall and an edge and a corner", "[unit][nearmiss]") {
  const auto c = ball4();
  const auto past = [&](const Vec3& from, const Vec3& to) {
    const auto all = check_near(block(), PathBuilder(from).rapid(to).pass(c));
    REQUIRE(all.size() == 1);
    return all[0];
  };
  check_left(past({-20, 12.3, -4}, {20, 12.3, -4}), 0.3);
  // The ball's centre, 2 above the tip, passes the long edge at (y, z) = (10, 0).
  check_left(past({-5, 11.6, -0.3}, {5, 11.6, -0.3}), std::hypot(1.6, 1.7) - 2);
  // And stands still beside a corner of the block.
  check_left(past({16.3, 11.3, -0.8}, {16.3, 11.3, -0.8}), std::hypot(1.3, 1.3, 1.2) - 2);
}

TEST_CASE("material removed before is no near miss and material removed later is",
          "[unit][nearmiss]") {
  const auto wide = cutter(CutterType::flat, 8, 20);
  // The slot's wall at y = 4 is 2.2 − 2 from the cutter 4 mm wide.
  const StockModel slotted =
      block().cut(PathBuilder({-25, 0, -3}).feed({25, 0, -3}).pass(wide), {2});
  const auto beside =
      check_near(slotted, PathBuilder({-25, 1.8, -2}).rapid({25, 1.8, -2}).pass(flat4()));
  REQUIRE(beside.size() == 1);
  check_left(beside[0], 0.2);
  CHECK(check_near(slotted, PathBuilder({-25, 1, -2}).rapid({25, 1, -2}).pass(flat4())).empty());
  const Pass wider_first = PathBuilder({-25, 3, -3})
                               .feed({25, 3, -3})
                               .rapid({25, 1.8, -2})
                               .rapid({-25, 1.8, -2})
                               .pass(flat4());
  const Pass wider_later = PathBuilder({25, 1.8, -2})
                               .rapid({-25, 1.8, -2})
                               .rapid({-25, 3, -3})
                               .feed({25, 3, -3})
                               .pass(flat4());
  CHECK(check_near(slotted, wider_first).empty());
  const auto later = check_near(slotted, wider_later);
  REQUIRE(later.size() == 1);
  CHECK(later[0].move == 0);
  check_left(later[0], 0.2);
}

TEST_CASE("shanks and holders near the stock on any move", "[unit][nearmiss]") {
  auto c = flat4(7);
  c.holder = {{10, 10}};
  const auto slot = [&](double depth) {
    return PathBuilder({-20, 0, -depth}).feed({20, 0, -depth}).pass(c);
  };
  CHECK(check_near(block(), slot(6)).empty());
  for (const double left : {0.4, 0.1, 0.0}) {
    const auto all = check_near(block(), slot(7 - left));
    REQUIRE(all.size() == 1);
    CHECK(all[0].part == "holder");
    check_left(all[0], left);
  }
  const auto deep = check_near(block(), slot(7.3));
  REQUIRE(deep.size() == 1);
  CHECK(deep[0].kind == FindingKind::holder_in_stock);
  // A neck in the slot that its own flutes cut has room all around.
  c = flat4(6);
  c.shank = {{3.5, 20}};
  const Pass levels = PathBuilder({-20, 0, -5})
                          .feed({20, 0, -5})
                          .rapid({20, 0, 3})
                          .rapid({-20, 0, 3})
                          .rapid({-20, 0, -7.5})
                          .feed({20, 0, -7.5})
                          .pass(c);
  CHECK(check_near(block(), levels).empty());
}

TEST_CASE("what the feed moves beside it come as near to is no near miss", "[unit][nearmiss]") {
  const auto c = ball4();
  // Down to 0.2 mm over the top, on into it, and out again.
  const Pass plunge =
      PathBuilder({0, 0, 20}).rapid({0, 0, 0.2}).feed({0, 0, -3}).rapid({0, 0, 20}).pass(c);
  CHECK(check_near(block(), plunge).empty());
  // The same way down, but up again without a cut.
  const Pass stray = PathBuilder({0, 0, 20}).rapid({0, 0, 0.2}).rapid({0, 0, 20}).pass(c);
  const auto all = check_near(block(), stray);
  REQUIRE(all.size() == 1);
  CHECK(all[0].move == 0);
  check_left(all[0], 0.2);
  // Down beside the stock and in from the side.
  const Pass side =
      PathBuilder({-17.3, 0, 20}).rapid({-17.3, 0, -3}).feed({0, 0, -3}).rapid({0, 0, 20}).pass(c);
  CHECK(check_near(block(), side).empty());
  // In two pieces, and slanted.
  CHECK(check_near(block(), split(plunge, 3)).empty());
  const Pass slanted =
      PathBuilder({-9, 0, 9}).rapid({0, 0, 0.2}).feed({3, 0, -2}).rapid({-6, 0, 7}).pass(c);
  CHECK(check_near(block(), slanted).empty());
  // A feed move only comes near the start of the rapid: the wall further on is missed closely.
  const auto slotter = cutter(CutterType::flat, 8, 20);
  const StockModel slotted =
      block().cut(PathBuilder({-25, 0, -3}).feed({25, 0, -3}).pass(slotter), {2});
  const Pass along = PathBuilder({-25, 1.8, -2.4})
                         .feed({-10, 1.8, -2.4})
                         .rapid({10, 1.8, -2.4})
                         .rapid({10, 1.8, 20})
                         .pass(flat4());
  const auto wall = check_near(slotted, along);
  REQUIRE(!wall.empty());
  CHECK(wall[0].move == 1);
  CHECK(-wall[0].depth_mm == Approx(0.2).margin(kTolerance));
}

TEST_CASE("rapids in pieces leave as little room", "[property][nearmiss]") {
  const auto worst = [](const Pass& pass) {
    double depth = -10;
    for (const Finding& f : of_kind(check_near(block(), pass), FindingKind::near_miss))
      depth = std::max(depth, f.depth_mm);
    return depth;
  };
  const Pass over = PathBuilder({-20, -5, 3}).rapid({3, 2, 0.15}).rapid({20, 9, 4}).pass(ball4());
  const double whole = worst(over);
  CHECK(whole == Approx(-0.15).margin(kTolerance));
  CHECK(worst(split(over, 9)) == Approx(whole).margin(kTolerance));
  const Pass back = PathBuilder({20, 9, 4}).rapid({3, 2, 0.15}).rapid({-20, -5, 3}).pass(ball4());
  CHECK(worst(back) == Approx(whole).margin(kTolerance));
}

TEST_CASE("the least gap agrees with dense sampling", "[property][nearmiss]") {
  std::mt19937_64 random(21);
  std::uniform_real_distribution<> x(-12, 12), up(-2, 3);
  const auto c = cutter(CutterType::bull, 5, 20, 1.5);
  PathBuilder cuts({0, 0, 20});
  for (int i = 0; i < 12; ++i) cuts.feed({x(random), x(random) * 0.6, up(random) - 1});
  const StockModel stock = block().cut(cuts.pass(c), {2});
  const simulator::CutterProfile body(4, 6);
  const simulator::SweepIndex none({c, std::make_shared<const model::Toolpath>()});
  constexpr double kStep = 0.2, kWithin = 2, kFine = 0.05;
  int near = 0;
  for (int k = 0; k < 12; ++k) {
    const simulator::SweptMove move({x(random), x(random), up(random) + 1.5},
                                    {x(random), x(random), up(random) + 1.5}, 0);
    double sampled = kWithin;
    for (double px = -15; px <= 15; px += kStep)
      for (double py = -10; py <= 10; py += kStep)
        for (double pz = -3; pz <= 0; pz += kStep) {
          const double d = swept_distance(body, move, {px, py, pz}).distance;
          if (d < sampled && stock.exact_value({px, py, pz}) <= 0) sampled = d;
        }
    sampled = std::max(0.0, sampled);
    const auto gap = least_gap({&stock.material(), &none, 0}, body, move, kWithin, kFine, {});
    const double found = gap ? gap->distance_mm : kWithin;
    // A sample of the material lies within a cell's diagonal of the nearest place, or a little
    // further where the material is sharp; crumbs do not count.
    CHECK(found >= sampled - 2 * kStep);
    CHECK(found <= sampled + 2 * kFine);
    if (!gap || gap->distance_mm == 0) continue;
    ++near;
    CHECK(stock.exact_value(gap->point) <= 1e-9);
    CHECK(swept_distance(body, move, gap->point).distance <= found + 1e-9);
  }
  CHECK(near > 2);
}

TEST_CASE("nothing is invented on a pocket with ramps and links", "[unit][nearmiss]") {
  auto c = flat4(10);
  c.shank = {{3.9, 6}};
  c.holder = {{16, 20}};
  c.steepest_descent_deg = 4;
  PathBuilder b({0, 0, 10});
  for (const double z : {-1.0, -2.0, -3.0}) {
    b.rapid({-4, 0, z + 1.2});
    // Down in a ramp to and fro, then rings outwards with links along the floor.
    for (int i = 1; i <= 3; ++i) b.feed({i % 2 ? 4.0 : -4.0, 0, z + 1.2 - 0.4 * i});
    b.feed({-4, 0, z}).feed({4, 0, z});
    for (const double r : {1.5, 3.0, 4.5}) {
      b.feed({4 + r, -r, z}).feed({4 + r, r, z}).feed({-4 - r, r, z});
      b.feed({-4 - r, -r, z}).feed({4 + r, -r, z});
    }
    b.rapid({0, 0, z});  // back over the floor
    b.rapid({0, 0, 10});
  }
  // And down into the corner again.
  b.rapid({8.5, 4.5, 10}).rapid({8.5, 4.5, -3}).feed({1.5, 4.5, -3.4}).rapid({1.5, 4.5, 10});
  for (const Finding& f : check_near(block(), b.pass(c)))
    UNSCOPED_INFO(name(f.kind) << " move " << f.move << " depth " << f.depth_mm);
  CHECK(check_near(block(), b.pass(c)).empty());
}

TEST_CASE("nothing is invented on a helix and on levels along a leaning wall", "[unit][nearmiss]") {
  auto c = cutter(CutterType::bull, 4, 10, 0.5);
  c.shank = {{4, 10}};
  PathBuilder b({2, 0, 10});
  b.rapid({2, 0, 0.3});
  for (int i = 1; i <= 200; ++i) {
    const double a = i * std::numbers::pi / 20;
    b.feed({2 * std::cos(a), 2 * std::sin(a), 0.3 - 0.02 * i});
  }
  b.rapid({2, 0, 10});
  // Levels whose wall leans inwards by 0.1 mm a level, each entered through its own hole.
  for (int k = 1; k <= 5; ++k) {
    const double r = 6 - 0.1 * k, z = -0.8 * k;
    b.rapid({r, 0, 10}).rapid({r, 0, z + 1});
    for (int i = 0; i <= 60; ++i) {
      const double a = i * std::numbers::pi / 30;
      b.feed({r * std::cos(a), r * std::sin(a), z});
    }
    b.rapid({r, 0, 10});
  }
  for (const Finding& f : check_near(block(), b.pass(c)))
    UNSCOPED_INFO(name(f.kind) << " move " << f.move << " depth " << f.depth_mm);
  CHECK(check_near(block(), b.pass(c)).empty());
}
