#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

#include "simulator/process/process_check.h"
#include "simulator/sweep/swept_distance.h"
#include "tests/simulator/paths.h"
#include "tests/support/catch.h"

namespace {

using namespace limitgauge;
using model::CutterType;
using model::Vec3;
using simulator::Finding;
using simulator::FindingKind;
using simulator::Pass;
using simulator::StockModel;
using simulator::test::cutter;
using simulator::test::PathBuilder;

constexpr double kStruckTolerance = 0.01;

// z from −8 to 0.
StockModel struck_block() {
  return {model::BoxStock{{-15, -10, -8}, {30, 20, 8}}, 0.25, std::size_t{1} << 30};
}

struct CollisionReport {
  std::vector<Finding> rapid, holder;
};

CollisionReport find_collisions(const StockModel& before, const Pass& pass, double tolerance,
                                const model::RunControl& control) {
  simulator::ProcessLimits limits;
  limits.tolerance_mm = tolerance;
  CollisionReport report;
  for (const Finding& f : check_process(before, pass, limits, control)) {
    if (f.kind == FindingKind::rapid_through_stock) report.rapid.push_back(f);
    // A shank narrower than the flutes is below_flutes.
    if (f.kind == FindingKind::shank_in_stock || f.kind == FindingKind::holder_in_stock ||
        f.kind == FindingKind::below_flutes)
      report.holder.push_back(f);
  }
  return report;
}

CollisionReport struck(const StockModel& before, const Pass& pass, unsigned threads = 2) {
  return find_collisions(before, pass, kStruckTolerance, {threads});
}

model::Cutter flat_of_4(double flutes = 20) {
  return cutter(CutterType::flat, 4, flutes);
}
model::Cutter ball_of_4() {
  return cutter(CutterType::ball, 4, 20);
}

}  // namespace

TEST_CASE("a rapid through standing material is reported with line, point and depth",
          "[unit][collision]") {
  const auto c = GENERATE(flat_of_4(), ball_of_4(), cutter(CutterType::bull, 4, 20, 1));
  const Pass pass = PathBuilder({-25, 0, 5})
                        .rapid({-20, 0, 5})
                        .rapid({-20, 0, -3})
                        .rapid({20, 0, -3})
                        .rapid({20, 0, 5})
                        .pass(c);
  const CollisionReport report = struck(struck_block(), pass);
  REQUIRE(report.rapid.size() == 1);
  const Finding& hit = report.rapid[0];
  CHECK(hit.move == 2);
  CHECK(hit.line == 3);
  CHECK(hit.part == "cutter");
  // The lowest of the cutter is 3 mm below the top; found to a tolerance, never too deep.
  CHECK(hit.depth_mm <= 3 + 1e-9);
  CHECK(hit.depth_mm >= 3 - kStruckTolerance);
  CHECK(hit.point.z == Approx(-3).margin(2 * kStruckTolerance));
  CHECK(std::abs(hit.point.x) < 15);
  CHECK(report.holder.empty());
}

TEST_CASE("a sloped rapid into the stock is found at its deepest", "[unit][collision]") {
  const Pass pass = PathBuilder({-20, 0, 8}).rapid({0, 0, -2}).rapid({0, 0, 8}).pass(ball_of_4());
  const CollisionReport report = struck(struck_block(), pass);
  REQUIRE(report.rapid.size() == 1);
  CHECK(report.rapid[0].line == 1);
  CHECK(report.rapid[0].depth_mm == Approx(2).margin(kStruckTolerance));
}

TEST_CASE("rapids through air are no collisions", "[unit][collision]") {
  const auto c = GENERATE(flat_of_4(), ball_of_4(), cutter(CutterType::taper, 2, 20, 0.5, 8));
  const Pass pass = PathBuilder({-20, 0, 5})
                        .rapid({-20, 0, 0.02})
                        .rapid({-8, 0, 0.02})
                        .feed({-8, 0, -3})
                        .feed({8, 0, -3})
                        .rapid({8, 0, 5})
                        .rapid({8, 0, -3})   // down again into the end of the slot
                        .rapid({-8, 0, -3})  // back along it
                        .rapid({-8, 0, 5})
                        .rapid({-18, 0, 5})
                        .rapid({-18, 0, -5})  // down beside the stock
                        .pass(c);
  const CollisionReport report = struck(struck_block(), pass);
  CHECK(report.rapid.empty());
  CHECK(report.holder.empty());
}

TEST_CASE("what is removed later still stands at the rapid", "[unit][collision]") {
  const Pass pass = PathBuilder({-20, 0, 5})
                        .rapid({-20, 0, -3})
                        .rapid({20, 0, -3})
                        .feed({-20, 0, -3})
                        .pass(flat_of_4());
  const CollisionReport report = struck(struck_block(), pass);
  REQUIRE(report.rapid.size() == 1);
  CHECK(report.rapid[0].line == 2);
}

TEST_CASE("what was removed earlier is no obstacle", "[unit][collision]") {
  PathBuilder feed({-20, 0, -3}), rapid({-20, 0, -3});
  feed.feed({20, 0, -3});
  rapid.rapid({20, 0, -3});
  const Pass back_in_slot =
      PathBuilder({-20, 0, -3}).feed({20, 0, -3}).rapid({-20, 0, -3}).pass(flat_of_4());
  CHECK(struck(struck_block(), back_in_slot).rapid.empty());
  // In an earlier stage.
  const StockModel after = struck_block().cut(feed.pass(flat_of_4()), {2});
  CHECK(struck(after, rapid.pass(flat_of_4())).rapid.empty());
  CHECK(struck(after, rapid.pass(ball_of_4())).rapid.empty());
  CHECK(struck(struck_block(), rapid.pass(flat_of_4())).rapid.size() == 1);
  // The second of two rapids along the same way meets nothing any more.
  const Pass twice =
      PathBuilder({-20, 0, -3}).rapid({20, 0, -3}).rapid({-20, 0, -3}).pass(flat_of_4());
  CHECK(struck(struck_block(), twice).rapid.size() == 1);
}

TEST_CASE("contacts up to the tolerance are let pass", "[unit][collision]") {
  const auto skim = [](double depth) {
    return PathBuilder({-20, 0, -depth}).rapid({20, 0, -depth}).pass(flat_of_4());
  };
  CHECK(struck(struck_block(), skim(0)).rapid.empty());
  CHECK(struck(struck_block(), skim(0.9 * kStruckTolerance)).rapid.empty());
  const CollisionReport report = struck(struck_block(), skim(2 * kStruckTolerance));
  REQUIRE(report.rapid.size() == 1);
  CHECK(report.rapid[0].depth_mm == Approx(2 * kStruckTolerance).margin(kStruckTolerance));
}

TEST_CASE("a shank wider than its slot collides", "[unit][collision]") {
  auto c = flat_of_4(3);
  c.shank = {{6, 20}};
  const Pass pass = PathBuilder({-20, 0, -6}).feed({0, 0, -6}).pass(c);
  const CollisionReport report = struck(struck_block(), pass);
  CHECK(report.rapid.empty());
  REQUIRE(report.holder.size() == 1);
  CHECK(report.holder[0].part == "shank");
  CHECK(report.holder[0].line == 1);
  // On the shank's side at radius 3 the depth is the smaller of −z and the distance to the slot's
  // rim at radius 2, z = −3: both are 5/3 at z = −5/3.
  CHECK(report.holder[0].depth_mm == Approx(5.0 / 3).margin(kStruckTolerance));
  CHECK(report.holder[0].point.z == Approx(-5.0 / 3).margin(0.05));
}

TEST_CASE("a shank that follows in its own slot does not collide", "[unit][collision]") {
  auto c = flat_of_4(3);
  c.shank = {{4, 20}};
  const Pass levels = PathBuilder({-20, 0, -3})
                          .feed({20, 0, -3})
                          .rapid({20, 0, 5})
                          .rapid({-20, 0, 5})
                          .rapid({-20, 0, -6})
                          .feed({20, 0, -6})
                          .pass(c);
  CHECK(struck(struck_block(), levels).holder.empty());
  const Pass plunge = PathBuilder({0, 0, 2}).feed({0, 0, -6}).rapid({0, 0, 5}).pass(c);
  CHECK(struck(struck_block(), plunge).holder.empty());
  CHECK(struck(struck_block(), plunge).rapid.empty());
  const Pass at_once = PathBuilder({-20, 0, -6}).feed({20, 0, -6}).pass(c);
  CHECK(struck(struck_block(), at_once).holder.size() == 1);
}

TEST_CASE("a holder that dips into the stock collides", "[unit][collision]") {
  auto c = flat_of_4(5);
  c.shank = {{3, 2}};
  c.holder = {{10, 4}, {14, 10}};
  const auto slot = [&](double z) { return PathBuilder({-25, 0, z}).feed({25, 0, z}).pass(c); };
  CHECK(struck(struck_block(), slot(-6.99)).holder.size() ==
        1);  // the shank in what the flutes left
  c.flute_length_mm = 7;
  c.shank.clear();
  CHECK(struck(struck_block(), slot(-6.99)).holder.empty());
  const CollisionReport report = struck(struck_block(), slot(-7.75));
  REQUIRE(report.holder.size() == 1);
  CHECK(report.holder[0].part == "holder");
  CHECK(report.holder[0].depth_mm == Approx(0.75).margin(kStruckTolerance));
}

TEST_CASE("the report is the same for any number of threads", "[property][collision]") {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<> x(-15, 15), z(-3, 4);
  PathBuilder b({0, 0, 20});
  for (int i = 0; i < 60; ++i) {
    const Vec3 to{x(random), x(random) / 2, z(random)};
    (random() % 3 == 0 ? b.rapid(to) : b.feed(to));
  }
  const Pass pass = b.pass(ball_of_4());
  const CollisionReport one = struck(struck_block(), pass, 1);
  REQUIRE(!one.rapid.empty());
  for (const unsigned threads : {2u, 3u}) {
    const CollisionReport other = struck(struck_block(), pass, threads);
    CHECK(std::equal(one.rapid.begin(), one.rapid.end(), other.rapid.begin(), other.rapid.end(),
                     [](const Finding& a, const Finding& c) {
                       return a.move == c.move && a.point == c.point && a.depth_mm == c.depth_mm;
                     }));
  }
}

TEST_CASE("depths agree with dense sampling of the swept body", "[property][collision]") {
  std::mt19937_64 random(8);
  std::uniform_real_distribution<> x(-9, 9), z(-4, 2);
  for (const auto& c : {flat_of_4(), ball_of_4(), cutter(CutterType::bull, 5, 20, 1.5)}) {
    const simulator::CutterProfile profile(c);
    PathBuilder b({0, 0, 20});
    for (int i = 0; i < 14; ++i) {
      const Vec3 to{x(random), x(random) / 2, z(random)};
      (i % 2 ? b.rapid(to) : b.feed(to));
    }
    const Pass pass = b.pass(c);
    const CollisionReport report = struck(struck_block(), pass);
    std::vector<simulator::SweptMove> moves;
    for (std::size_t m = 0; m < pass.path->moves.size(); ++m)
      moves.emplace_back(move_from(*pass.path, m), pass.path->moves[m].to,
                         static_cast<std::uint32_t>(m));
    const StockModel raw = struck_block();
    constexpr double kStep = 0.2;
    for (std::size_t m = 1; m < moves.size(); m += 2) {
      double deepest = 0;
      for (double px = -14.9; px < 15; px += kStep)
        for (double py = -9.9; py < 10; py += kStep)
          for (double pz = -4; pz < 0; pz += kStep) {
            const Vec3 p{px, py, pz};
            double depth = std::min({-pz, pz + 8, 15 - std::abs(px), 10 - std::abs(py)});
            if (depth <= deepest || swept_distance(profile, moves[m], p).distance > 0) continue;
            for (std::size_t k = 0; k < m && depth > deepest; ++k)
              depth = std::min(depth, swept_distance(profile, moves[k], p).distance);
            deepest = std::max(deepest, depth);
          }
      const auto hit = std::find_if(report.rapid.begin(), report.rapid.end(),
                                    [&](const Finding& h) { return h.move == m; });
      const double found = hit == report.rapid.end() ? 0 : hit->depth_mm;
      // A sample lies within half a diagonal of the deepest place, but may fall outside the body
      // there: a whole diagonal covers a convex body's corner.
      CHECK(found >= deepest - 1.5 * kStruckTolerance);
      CHECK(found <= deepest + kStep * std::sqrt(3.0));
      if (found == 0) continue;
      CHECK(swept_distance(profile, moves[m], hit->point).distance <= 1e-9);
      double there = -raw.exact_value(hit->point);
      for (std::size_t k = 0; k < m; ++k)
        there = std::min(there, swept_distance(profile, moves[k], hit->point).distance);
      CHECK(there == Approx(found).margin(1e-9));
    }
  }
}

TEST_CASE("a tolerance that is none is refused", "[unit][collision]") {
  const Pass pass = PathBuilder({0, 0, 5}).rapid({1, 0, 5}).pass(ball_of_4());
  CHECK_THROWS_AS(find_collisions(struck_block(), pass, 0, {1}), std::invalid_argument);
  CHECK_THROWS_AS(find_collisions(struck_block(), {ball_of_4(), nullptr}, 0.01, {1}),
                  std::invalid_argument);
}

TEST_CASE("nothing collides where nothing stands", "[unit][collision]") {
  const auto wide = cutter(CutterType::flat, 60, 40);
  const StockModel nothing =
      struck_block().cut(PathBuilder({-50, 0, -20}).feed({50, 0, -20}).pass(wide), {2});
  const Pass pass = PathBuilder({-20, 0, -3}).rapid({20, 0, -3}).pass(ball_of_4());
  CHECK(struck(nothing, pass).rapid.empty());
}

TEST_CASE("a rapid back along the way of the feed move before it meets nothing there",
          "[unit][process]") {
  // A side that leans inwards: the flutes' widest place is the lowest, and what is left above it
  // lies against their way back.
  const model::Cutter dovetail = model::parse_cutter("apt:D=8,L=3,r=0,a=0,b=-5");
  const Vec3 above{12.68, 3.06, 20}, down{12.68, 3.06, -3.47};
  const auto plunge = [&] { return PathBuilder({12.68, 3.06, 30}).rapid(above).feed(down); };
  CHECK(check(block(), plunge().rapid({12.68, 3.06, 15}).pass(dovetail)).empty());
  CHECK(check(block(), plunge().rapid({12.68, 3.06, 40}).pass(dovetail)).empty());
  // Aside on the way, or on beyond where the feed began.
  const auto aside = check(block(), plunge().rapid({12.68, 2.56, 20}).pass(dovetail));
  CHECK(count_of(aside, FindingKind::rapid_through_stock) == 1);
  const auto through = PathBuilder({0, 0, 20}).feed({0, 0, -3}).feed({5, 0, -3});
  PathBuilder back = through, beyond = through;
  CHECK(check(block(), back.rapid({0, 0, -3}).pass(flat4())).empty());
  const auto hit = check(block(), beyond.rapid({-5, 0, -3}).pass(flat4()));
  REQUIRE(count_of(hit, FindingKind::rapid_through_stock) == 1);
  CHECK(hit[0].point.x < 0);
  // A line of feeds that bends by less than shows in its directions is not straight for all that.
  const auto bent =
      PathBuilder({-14, 0, -3}).feed({-13, 0, -3}).feed({0, 0.0012, -3}).feed({13, 0, -3});
  PathBuilder chord = bent;
  simulator::ProcessLimits fine = plain_limits();
  fine.tolerance_mm = 0.0005;
  const auto across = check(block(), chord.rapid({-13, 0, -3}).pass(flat4()), fine);
  CHECK(count_of(across, FindingKind::rapid_through_stock) == 1);
  CHECK(hit[0].depth_mm == Approx(3).margin(0.01));
}
