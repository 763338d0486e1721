#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
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
  CHECK(count_of(check(block(), removed_later), FindingKind::rapid_through_stock) == 1);
  CHECK(check(block(), removed_before).empty());
  CHECK(count_of(check(block(), rapid), FindingKind::rapid_through_stock) == 1);
  // In an earlier stage.
  CHECK(check(block().cut(slot(c, 3), {2}), rapid).empty());
  // The second of two rapids along the same way meets nothing any more.
  const Pass twice = PathBuilder({-20, 0, -3}).rapid({20, 0, -3}).rapid({-20, 0, -3}).pass(c);
  CHECK(count_of(check(block(), twice), FindingKind::rapid_through_stock) == 1);
}

TEST_CASE("a rapid's way through a block is as deep in small bent steps", "[unit][process]") {
  // Into a side of the block along an arc of 30 mm, in steps shallower than the tolerance.
  const auto along = [](int steps) {
    PathBuilder path({-17.5, 0, -3});
    for (int i = 1; i <= 2 * steps; ++i) {
      const double angle = 0.04 * std::min(i, 2 * steps - i) / steps;
      path.rapid({30 * std::sin(angle) - 17.5, 30 * std::cos(angle) - 30, -3});
    }
    return path.pass(flat4());
  };
  const auto coarse = check(block(), along(10)), fine = check(block(), along(130));
  const double deep = worst_of(coarse, FindingKind::rapid_through_stock);
  CHECK(deep > 0.65);
  CHECK(worst_of(fine, FindingKind::rapid_through_stock) == Approx(deep).margin(2 * kTolerance));
  // The way back goes through what was taken on the way there, and is none.
  CHECK(of_kind(coarse, FindingKind::rapid_through_stock).back().move < 10);
  CHECK(of_kind(fine, FindingKind::rapid_through_stock).back().move < 130);
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
    const double whole = worst_of(check(block(), pass), FindingKind::rapid_through_stock);
    CHECK(whole == Approx(3).margin(kTolerance));
    CHECK(worst_of(check(block(), split(pass, 400)), FindingKind::rapid_through_stock) ==
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
  CHECK(count_of(pieces, FindingKind::spindle_stopped) > 3000);
  CHECK(worst_of(pieces, FindingKind::spindle_stopped) == Approx(3).margin(kTolerance));
  // At rest in air, and in a slot that is there already.
  CHECK(check(block(), spindle_at_rest(slot(flat4(), 0), 0, 1)).empty());
  CHECK(check(block().cut(turning, {2}), spindle_at_rest(turning, 0, 1)).empty());
}

TEST_CASE("the spindle that comes to rest after the cut is no finding", "[unit][process]") {
  const Pass pass = PathBuilder({0, 0, 5}).feed({0, 0, -3}).rapid({0, 0, 5}).pass(flat4());
  CHECK(check(block(), spindle_at_rest(pass, 1, 2)).empty());
  CHECK(count_of(check(block(), spindle_at_rest(pass, 0, 2)), FindingKind::spindle_stopped) == 1);
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
