#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <stdexcept>

#include "model/base/error.h"
#include "simulator/sweep/swept_distance.h"
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
using simulator::ProcessLimits;
using simulator::StockModel;

std::size_t count(const std::vector<Finding>& all, FindingKind kind) {
  return of_kind(all, kind).size();
}

double worst(const std::vector<Finding>& all, FindingKind kind) {
  double depth = -1;
  for (const Finding& f : of_kind(all, kind)) depth = std::max(depth, f.depth_mm);
  return depth;
}

Pass spindle_at_rest(const Pass& pass, std::size_t from, std::size_t to) {
  return changed(pass, [&](model::Toolpath& path) {
    for (std::size_t i = from; i < to; ++i) path.moves[i].spindle_stopped = true;
  });
}

Pass without_feed(const Pass& pass) {
  return changed(pass, [](model::Toolpath& path) {
    for (model::Move& m : path.moves) m.feed_mm_min = 0;
  });
}

// A slot along x whose floor is `depth` below the top, entered from the side.
Pass slot(const model::Cutter& c, double depth) {
  return PathBuilder({-20, 0, -depth}).feed({20, 0, -depth}).pass(c);
}

}  // namespace

TEST_CASE("a rapid through standing material has line and place and depth", "[unit][process]") {
  const auto c = GENERATE(flat4(), ball4(), cutter(CutterType::bull, 4, 20, 1));
  const auto path = [&](double z) {
    return PathBuilder({-25, 0, 5})
        .rapid({-20, 0, 5})
        .rapid({-20, 0, z})
        .rapid({20, 0, z})
        .rapid({20, 0, 5})
        .pass(c);
  };
  const auto all = check(block(), path(-3));
  REQUIRE(all.size() == 1);
  const Finding& hit = all[0];
  CHECK(hit.kind == FindingKind::rapid_through_stock);
  CHECK(hit.move == 2);
  CHECK(hit.line == 3);
  CHECK(hit.part == "cutter");
  CHECK(hit.against == "stock");
  // The lowest of the cutter is 3 mm below the top; found to a tolerance, never too deep.
  CHECK(hit.depth_mm <= 3 + 1e-9);
  CHECK(hit.depth_mm >= 3 - kTolerance);
  CHECK(hit.point.z == Approx(-3).margin(2 * kTolerance));
  CHECK(std::abs(hit.point.x) < 15);
  CHECK(check(block(), path(0)).empty());
}

TEST_CASE("the stock is judged as it is when the rapid comes", "[unit][process]") {
  const auto c = flat4();
  const auto removed_later =
      PathBuilder({-20, 0, 5}).rapid({-20, 0, -3}).rapid({20, 0, -3}).feed({-20, 0, -3}).pass(c);
  const auto removed_before =
      PathBuilder({-20, 0, -3}).feed({20, 0, -3}).rapid({-20, 0, -3}).pass(c);
  const auto rapid = PathBuilder({-20, 0, -3}).rapid({20, 0, -3}).pass(c);
  CHECK(count(check(block(), removed_later), FindingKind::rapid_through_stock) == 1);
  CHECK(check(block(), removed_before).empty());
  CHECK(count(check(block(), rapid), FindingKind::rapid_through_stock) == 1);
  // In an earlier stage.
  CHECK(check(block().cut(slot(c, 3), {2}), rapid).empty());
  // The second of two rapids along the same way meets nothing any more.
  const Pass twice = PathBuilder({-20, 0, -3}).rapid({20, 0, -3}).rapid({-20, 0, -3}).pass(c);
  CHECK(count(check(block(), twice), FindingKind::rapid_through_stock) == 1);
}

TEST_CASE("a rapid's way through a block is as deep in small bent steps", "[unit][process]") {
  // Into a side of the block along an arc of 30 mm, in steps shallower than the tolerance.
  const auto along = [](int steps) {
    PathBuilder path({-17.5, 0, -3});
    for (int i = 1; i <= 2 * steps; ++i) {
      const double angle = 0.06 * std::min(i, 2 * steps - i) / steps;
      path.rapid({30 * std::sin(angle) - 17.5, 30 * std::cos(angle) - 30, -3});
    }
    return path.pass(flat4());
  };
  const auto coarse = check(block(), along(10)), fine = check(block(), along(200));
  const double deep = worst(coarse, FindingKind::rapid_through_stock);
  CHECK(deep > 1.1);
  CHECK(worst(fine, FindingKind::rapid_through_stock) == Approx(deep).margin(2 * kTolerance));
  // The way back goes through what was taken on the way there, and is none.
  CHECK(of_kind(coarse, FindingKind::rapid_through_stock).back().move < 10);
  CHECK(of_kind(fine, FindingKind::rapid_through_stock).back().move < 200);
}

TEST_CASE("rapids through air and along surfaces are no findings", "[unit][process]") {
  const auto c = GENERATE(flat4(), ball4(), cutter(CutterType::taper, 2, 20, 0.5, 8));
  const double near_miss = GENERATE(0.0, 0.5);
  const Pass pass = PathBuilder({-20, 0, 5})
                        .rapid({-20, 0, 0})
                        .rapid({-8, 0, 0})  // sliding along the top
                        .feed({-8, 0, -3})
                        .feed({8, 0, -3})
                        .rapid({8, 0, 5})
                        .rapid({8, 0, -3})   // down again into the end of the slot
                        .rapid({-8, 0, -3})  // back along it
                        .rapid({-8, 0, 5})
                        .rapid({-18, 0, 5})
                        .pass(c);
  CHECK(check(block(), pass, plain_limits(near_miss)).empty());
}

TEST_CASE("a line in pieces is judged as a whole", "[property][process]") {
  // Each piece is shorter than the tolerance: alone, it would shave off less than counts.
  const Pass rapid = PathBuilder({-14, 0, -3}).rapid({-12, 0, -3}).pass(ball4());
  const Pass plunge = PathBuilder({0, 0, 0}).rapid({0, 0, -3}).pass(flat4());
  for (const Pass& pass : {rapid, plunge}) {
    const double whole = worst(check(block(), pass), FindingKind::rapid_through_stock);
    CHECK(whole == Approx(3).margin(kTolerance));
    CHECK(worst(check(block(), split(pass, 400)), FindingKind::rapid_through_stock) ==
          Approx(whole).margin(kTolerance));
  }
}

TEST_CASE("a move with the spindle at rest that meets material", "[unit][process]") {
  const Pass turning = slot(flat4(), 3);
  CHECK(check(block(), turning).empty());
  const auto all = check(block(), spindle_at_rest(turning, 0, 1));
  REQUIRE(all.size() == 1);
  CHECK(all[0].kind == FindingKind::spindle_stopped);
  CHECK(all[0].line == 1);
  CHECK(all[0].depth_mm == Approx(3).margin(kTolerance));
  // In pieces shorter than the tolerance.
  const auto pieces = check(block(), spindle_at_rest(split(turning, 4500), 0, 4500));
  CHECK(count(pieces, FindingKind::spindle_stopped) > 3000);
  CHECK(worst(pieces, FindingKind::spindle_stopped) == Approx(3).margin(kTolerance));
  // At rest in air, and in a slot that is there already.
  CHECK(check(block(), spindle_at_rest(slot(flat4(), 0), 0, 1)).empty());
  CHECK(check(block().cut(turning, {2}), spindle_at_rest(turning, 0, 1)).empty());
}

TEST_CASE("the spindle that comes to rest after the cut is no finding", "[unit][process]") {
  const Pass pass = PathBuilder({0, 0, 5}).feed({0, 0, -3}).rapid({0, 0, 5}).pass(flat4());
  CHECK(check(block(), spindle_at_rest(pass, 1, 2)).empty());
  CHECK(count(check(block(), spindle_at_rest(pass, 0, 2)), FindingKind::spindle_stopped) == 1);
}

TEST_CASE("a feed move without a feed rate", "[unit][process]") {
  const Pass pass = PathBuilder({-20, 0, 5})
                        .rapid({-20, 0, -3})
                        .feed({-18, 0, -3})
                        .feed({20, 0, -3})
                        .pass(flat4());
  CHECK(check(block(), pass).empty());
  const auto all = check(block(), without_feed(pass));
  REQUIRE(all.size() == 2);
  CHECK(all[0].kind == FindingKind::feed_missing);
  CHECK(all[0].line == 2);
  CHECK(all[0].depth_mm == 0);
  CHECK(all[0].point == Vec3{-20, 0, -3});
  CHECK(all[1].line == 3);
  CHECK(all[1].depth_mm == Approx(3).margin(kTolerance));
}

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
  CHECK(check(block(), split(hole, 7)).empty());
  // A shank that is wider than the top by 0.2 mm stands in the wall.
  c.shank = {{2 * simulator::CutterProfile(c).largest_radius() + 0.4, 20}};
  const auto wider = check(block(), PathBuilder({0, 0, 5}).feed({0, 0, -5}).pass(c));
  CHECK(worst(wider, FindingKind::shank_in_stock) == Approx(0.2).margin(kTolerance));
}

TEST_CASE("a part above the flutes as wide as they are speaks for itself", "[unit][process]") {
  auto c = flat4(5);
  c.shank = {{4, 20}};
  auto all = check(block(), slot(c, 7));
  REQUIRE(all.size() == 1);
  CHECK(all[0].kind == FindingKind::shank_in_stock);
  // A neck: material stands above the flutes, whether the neck meets it or not.
  c.shank = {{3, 20}};
  all = check(block(), slot(c, 7));
  REQUIRE(all.size() == 1);
  CHECK(all[0].kind == FindingKind::below_flutes);
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
  CHECK(worst(check(block(), stairs(0.0095, 0.001)), FindingKind::steep_descent) ==
        Approx(0.15).margin(0.03));
  // Layers of it are none: each is cut level over more than the descent would take at 5 degrees.
  CHECK(count(check(block(), stairs(0.0095, 0.5)), FindingKind::steep_descent) == 0);
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
  CHECK(count(check(block(), path.pass(c)), FindingKind::steep_descent) == 0);
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
  CHECK(worst(check(block(), split(ramp(6), 300)), FindingKind::steep_descent) ==
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

TEST_CASE("a tip beyond the travel", "[unit][process]") {
  constexpr double kNone = std::numeric_limits<double>::infinity();
  ProcessLimits limits = plain_limits();
  limits.travel_mm = model::Box3{{-20, -kNone, -kNone}, {20, kNone, 30}};
  const auto path = [](double x, double z) {
    return PathBuilder({0, 0, 5})
        .rapid({x, 0, 10})
        .rapid({0, 0, z})
        .rapid({0, 900, 5})
        .pass(flat4());
  };
  CHECK(check(block(), path(20, 30), limits).empty());
  const auto all = check(block(), path(-20.5, 31.25), limits);
  REQUIRE(all.size() == 2);
  CHECK(all[0].kind == FindingKind::beyond_travel);
  CHECK(all[0].move == 0);
  CHECK(all[0].depth_mm == 0.5);
  CHECK(all[0].against == "x-");
  CHECK(all[0].point == Vec3{-20.5, 0, 10});
  CHECK(all[1].depth_mm == 1.25);
  CHECK(all[1].against == "z+");
}

TEST_CASE("contacts up to the tolerance fail nothing", "[unit][process]") {
  const auto skim = [](double depth) {
    return PathBuilder({-20, 0, -depth}).rapid({20, 0, -depth}).pass(flat4());
  };
  for (const Finding& f : check(block(), skim(0.9 * kTolerance)))
    CHECK(f.kind == FindingKind::slight_contact);
  CHECK(check(block(), skim(0.09 * kTolerance)).empty());
  const auto all = check(block(), skim(2 * kTolerance));
  REQUIRE(all.size() == 1);
  CHECK(all[0].depth_mm == Approx(2 * kTolerance).margin(kTolerance));
}

TEST_CASE("depths of rapids agree with dense sampling", "[property][process]") {
  std::mt19937_64 random(8);
  std::uniform_real_distribution<> x(-9, 9), z(-4, 2);
  for (const auto& c : {flat4(), ball4(), cutter(CutterType::bull, 5, 20, 1.5)}) {
    const simulator::CutterProfile profile(c);
    PathBuilder b({0, 0, 20});
    for (int i = 0; i < 14; ++i) {
      const Vec3 to{x(random), x(random) / 2, z(random)};
      (i % 2 ? b.rapid(to) : b.feed(to));
    }
    const Pass pass = b.pass(c);
    const auto all = of_kind(check(block(), pass), FindingKind::rapid_through_stock);
    std::vector<simulator::SweptMove> moves;
    for (std::size_t m = 0; m < pass.path->moves.size(); ++m)
      moves.emplace_back(move_from(*pass.path, m), pass.path->moves[m].to,
                         static_cast<std::uint32_t>(m));
    const auto depth_at = [&](const Vec3& p, std::size_t m, double enough) {
      double depth = std::min({-p.z, p.z + 8, 15 - std::abs(p.x), 10 - std::abs(p.y)});
      for (std::size_t k = 0; k < m && depth > enough; ++k)
        depth = std::min(depth, swept_distance(profile, moves[k], p).distance);
      return depth;
    };
    constexpr double kStep = 0.25;
    for (std::size_t m = 1; m < moves.size(); m += 2) {
      double deepest = 0;
      for (double px = -14.9; px < 15; px += kStep)
        for (double py = -9.9; py < 10; py += kStep)
          for (double pz = -4; pz < 0; pz += kStep)
            if (swept_distance(profile, moves[m], {px, py, pz}).distance <= 0)
              deepest = std::max(deepest, depth_at({px, py, pz}, m, deepest));
      const auto hit =
          std::find_if(all.begin(), all.end(), [&](const Finding& h) { return h.move == m; });
      const double found = hit == all.end() ? 0 : hit->depth_mm;
      // A sample lies within half a diagonal of the deepest place, but may fall outside the body
      // there: a whole diagonal covers a convex body's corner.
      CHECK(found >= deepest - 1.5 * kTolerance);
      CHECK(found <= deepest + kStep * std::sqrt(3.0));
      if (found == 0) continue;
      CHECK(swept_distance(profile, moves[m], hit->point).distance <= 1e-9);
      CHECK(depth_at(hit->point, m, -1) == Approx(found).margin(1e-9));
    }
  }
}

TEST_CASE("limits that cannot be are refused", "[unit][process]") {
  const Pass pass = PathBuilder({0, 0, 5}).rapid({1, 0, 5}).pass(ball4());
  ProcessLimits limits;
  CHECK_THROWS_AS(check(block(), pass, limits), std::invalid_argument);
  limits.tolerance_mm = 0.1;
  CHECK(check(block(), pass, limits).empty());
  limits.near_miss_mm = -1;
  CHECK_THROWS_AS(check(block(), pass, limits), std::invalid_argument);
  limits.near_miss_mm = 0;
  limits.travel_mm = model::Box3{{0, 0, 0}, {1, 1, std::nan("")}};
  CHECK_THROWS_AS(check(block(), pass, limits), std::invalid_argument);
  CHECK_THROWS_AS(check(block(), {ball4(), nullptr}), std::invalid_argument);
  const Pass lost = PathBuilder({0, 0, 5}).rapid({std::nan(""), 0, 5}).pass(ball4());
  CHECK_THROWS_AS(check(block(), lost), std::invalid_argument);
}

TEST_CASE("the check can be stopped and says how far it is", "[unit][process]") {
  const Pass pass = split(slot(flat4(), 3), 300);
  double last = 0;
  check_process(block(), pass, plain_limits(), {1, nullptr, [&](double f) { last = f; }});
  CHECK(last == 1);
  const std::atomic<bool> stop = true;
  CHECK_THROWS_AS(check_process(block(), pass, plain_limits(), {2, &stop, {}}), model::Interrupted);
}

TEST_CASE("nothing is found where nothing stands", "[unit][process]") {
  const auto wide = cutter(CutterType::flat, 60, 40);
  const StockModel nothing =
      block().cut(PathBuilder({-50, 0, -20}).feed({50, 0, -20}).pass(wide), {2});
  auto c = ball4();
  c.holder = {{40, 50}};
  const Pass pass = PathBuilder({-20, 0, -3}).rapid({20, 0, -3}).pass(c);
  CHECK(check(nothing, pass, plain_limits(3)).empty());
}
