// What a tool touches that turns as it goes.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "simulator/process/process_check.h"
#include "tests/simulator/paths.h"
#include "tests/simulator/turning/turning_bench.h"
#include "tests/support/catch.h"

namespace {

using namespace limitgauge;
using model::Pass;
using model::Vec3;
using simulator::Finding;
using simulator::FindingKind;
using simulator::StockModel;
using namespace simulator::test;

model::Cutter shanked() {
  model::Cutter c = model::parse_cutter("ball:D=6,L=10");
  c.shank.push_back({6, 20});
  c.holder.push_back({20, 30});
  return c;
}

StockModel block_as_it_is() {
  return {turning_block(), 0.5, std::size_t{1} << 30};
}

simulator::ProcessLimits limits(double near_mm = 0) {
  simulator::ProcessLimits l;
  l.tolerance_mm = 0.05, l.near_miss_mm = near_mm;
  return l;
}

std::vector<Finding> of(const Pass& pass, const simulator::ProcessLimits& l, unsigned threads = 2) {
  return check_process(block_as_it_is(), pass, l, {threads});
}

bool any(const std::vector<Finding>& all, FindingKind kind) {
  return std::any_of(all.begin(), all.end(), [&](const Finding& f) { return f.kind == kind; });
}

Pass rapids(const Pass& pass) {
  model::Toolpath path = *pass.path;
  for (model::Move& m : path.moves) m.kind = model::MoveKind::rapid;
  Pass out = pass;
  out.path = std::make_shared<const model::Toolpath>(path);
  return out;
}

/// The tip stands and the axis turns, 5 mm above the block's top.
TurnedMove turn_above(double lean) {
  return {{0, 0, 5}, {0, 0, 5}, {0, 0, 1}, {std::sin(lean), 0, std::cos(lean)}};
}

}  // namespace

TEST_CASE("a tool that turns above the block touches nothing", "[unit][turning]") {
  CHECK(of(with_axes(shanked(), {turn_above(0.5)}), limits()).empty());
  CHECK(of(rapids(with_axes(shanked(), {turn_above(0.5)})), limits()).empty());
}

TEST_CASE("a holder that leans into the block is found where it does", "[unit][turning]") {
  // At 80 degrees the holder, 30 mm up and 10 mm in radius, hangs beside the tip below the top.
  const auto found = of(with_axes(shanked(), {turn_above(1.4)}), limits());
  CHECK_FALSE(any(found, FindingKind::holder_in_stock));
  TurnedMove low = turn_above(1.4);
  low.from = low.to = {-25, 0, 2};
  const auto deep = of(with_axes(shanked(), {low}), limits());
  REQUIRE(any(deep, FindingKind::holder_in_stock));
  for (const Finding& f : deep)
    if (f.kind == FindingKind::holder_in_stock) {
      CHECK(f.depth_mm > 0.05);
      CHECK(f.point.z <= 0);
      CHECK(f.move == 0);
    }
}

TEST_CASE("a rapid that turns into the block is found, a feed move is not", "[unit][turning]") {
  const TurnedMove dive{{0, 0, 5}, {2, 0, -2}, {0, 0, 1}, {0.6, 0, 0.8}};
  CHECK_FALSE(any(of(with_axes(shanked(), {dive}), limits()), FindingKind::rapid_through_stock));
  const auto found = of(rapids(with_axes(shanked(), {dive})), limits());
  REQUIRE(any(found, FindingKind::rapid_through_stock));
  // The ball's centre ends 0.4 mm above the top.
  CHECK(found.front().depth_mm > 2.5);
  CHECK(found.front().depth_mm < 2.61);
  // Out along its axis, where it was cut.
  TurnedMove out{{2, 0, -2}, {8, 0, 6}, {0.6, 0, 0.8}, {0.6, 0, 0.8}};
  model::Toolpath path = *with_axes(shanked(), {dive, out}).path;
  path.moves[1].kind = model::MoveKind::rapid;
  Pass pass = with_axes(shanked(), {dive, out});
  pass.path = std::make_shared<const model::Toolpath>(path);
  CHECK_FALSE(any(of(pass, limits(0.5)), FindingKind::rapid_through_stock));
  CHECK_FALSE(any(of(pass, limits(0.5)), FindingKind::near_miss));
}

TEST_CASE("a turning rapid that passes near the block is a near miss", "[unit][turning]") {
  const TurnedMove over{{-30, 0, 0.3}, {30, 0, 0.3}, {0, 0, 1}, {0, 0.1, std::sqrt(0.99)}};
  const auto found = of(rapids(with_axes(shanked(), {over})), limits(0.5));
  REQUIRE(any(found, FindingKind::near_miss));
  CHECK(found.front().depth_mm == Approx(-0.3).margin(0.06));
  CHECK(of(rapids(with_axes(shanked(), {over})), limits(0.1)).empty());
}

TEST_CASE("feeds, spindles, travel and descents are told of turning moves too", "[unit][turning]") {
  const TurnedMove dive{{0, 0, 5}, {0, 0, -2}, {0, 0, 1}, {0.28, 0, 0.96}};
  Pass pass = with_axes(shanked(), {dive});
  model::Toolpath path = *pass.path;
  path.moves[0].feed_mm_min = 0, path.moves[0].spindle_stopped = true;
  pass.path = std::make_shared<const model::Toolpath>(path);
  pass.cutter.steepest_descent_deg = 10;
  auto l = limits();
  l.travel_mm = model::Box3{{-9, -9, 0}, {9, 9, 9}};
  const auto found = of(pass, l);
  for (const FindingKind kind : {FindingKind::feed_missing, FindingKind::spindle_stopped,
                                 FindingKind::steep_descent, FindingKind::beyond_travel})
    CHECK(any(found, kind));
}

TEST_CASE("findings of turning moves are the same on any number of threads",
          "[property][turning]") {
  const Pass pass = rapids(turning_pass(shanked(), 3, 30));
  const auto one = of(pass, limits(0.3), 1), two = of(pass, limits(0.3), 2);
  REQUIRE(one.size() == two.size());
  REQUIRE_FALSE(one.empty());
  for (std::size_t k = 0; k < one.size(); ++k) {
    CHECK(one[k].kind == two[k].kind);
    CHECK(one[k].depth_mm == two[k].depth_mm);
  }
}

TEST_CASE("what earlier moves of the pass have cut is gone for later ones", "[unit][turning]") {
  // The second dive, a rapid, follows a first one that fed the same way.
  const TurnedMove dive{{0, 0, 5}, {0, 0, -2}, {0, 0, 1}, {0.28, 0, 0.96}};
  const TurnedMove up{{0, 0, -2}, {0, 0, 5}, {0.28, 0, 0.96}, {0, 0, 1}};
  Pass pass = with_axes(shanked(), {dive, up, dive});
  model::Toolpath path = *pass.path;
  path.moves[2].kind = model::MoveKind::rapid;
  pass.path = std::make_shared<const model::Toolpath>(path);
  CHECK_FALSE(any(of(pass, limits()), FindingKind::rapid_through_stock));
}

TEST_CASE("a shank is in what its own flutes come to only later", "[unit][turning]") {
  // The axis swings across the way, so that a place above the flutes is below their top a while
  // later. Said in one move as in many; the flutes of one move had always been there before.
  model::Cutter c = model::parse_cutter("flat:D=6,L=6");
  c.shank.push_back({6, 30});
  const auto swing = [&](int pieces) {
    const double half = 0.25;
    const auto axis = [&](int k) {
      const double lean = half * (1 - 2.0 * k / pieces);
      return Vec3{0, -std::sin(lean), std::cos(lean)};
    };
    const auto tip = [&](int k) { return Vec3{4.0 * k / pieces - 2, 0, 0}; };
    std::vector<TurnedMove> moves;
    for (int k = 0; k < pieces; ++k) moves.push_back({tip(k), tip(k + 1), axis(k), axis(k + 1)});
    return with_axes(c, moves);
  };
  const StockModel bit{model::BoxStock{{1.6, 0.6, 5.5}, {0.8, 0.8, 0.8}}, 0.1,
                       std::size_t{1} << 30};
  simulator::ProcessLimits l = limits();
  l.tolerance_mm = 0.01;
  const auto deepest = [&](int pieces) {
    double most = -1;
    for (const Finding& f : check_process(bit, swing(pieces), l, {2}))
      if (f.kind == FindingKind::shank_in_stock) most = std::max(most, f.depth_mm);
    return most;
  };
  const double many = deepest(32);
  CHECK(many > 0.1);
  CHECK(deepest(1) > 0.5 * many);
  CHECK(deepest(1) < many + 0.01);
  CHECK(deepest(4) > 0.5 * many);
}

TEST_CASE("a shank that follows its flutes into what they have cut meets nothing",
          "[unit][turning][slow]") {
  // Down its own axis, which turns a little on the way: the flutes were there before.
  model::Cutter c = model::parse_cutter("flat:D=6,L=6");
  c.shank.push_back({5.9, 30});
  const TurnedMove dive{{0, 0, 1}, {0, 0, -9}, {0, 0, 1}, {std::sin(0.002), 0, std::cos(0.002)}};
  simulator::ProcessLimits l = limits();
  CHECK_FALSE(any(of(with_axes(c, {dive}), l), FindingKind::shank_in_stock));
}

TEST_CASE("a shank as wide as its flutes follows them down a leaning axis, but for rounding",
          "[unit][turning]") {
  model::Cutter c = model::parse_cutter("flat:D=3,L=3");
  c.shank.push_back({3, 60});
  const double lean = 0.35;
  const auto along = [&](double mm) { return Vec3{std::sin(lean), 0, std::cos(lean)} * mm; };
  const auto dive = [&](double off_rad) {
    const Vec3 end{std::sin(lean + off_rad), 0, std::cos(lean + off_rad)};
    return with_axes(
        c, {{along(60), along(2), along(1), along(1)}, {along(2), along(-6), along(1), end}});
  };
  simulator::ProcessLimits l = limits();
  l.tolerance_mm = 0.01;
  CHECK_FALSE(any(of(dive(0), l), FindingKind::shank_in_stock));
  CHECK_FALSE(any(of(dive(1e-5), l), FindingKind::shank_in_stock));
  // A tenth of a radian is no rounding.
  CHECK(any(of(dive(0.1), l), FindingKind::shank_in_stock));
}

TEST_CASE("a tool goes back up its axis from where it has just cut as it turned",
          "[unit][turning]") {
  const auto leaning = [](double deg) {
    const double rad = deg * std::numbers::pi / 180;
    return Vec3{std::sin(rad), 0, std::cos(rad)};
  };
  const Vec3 axis = leaning(40), turned = leaning(40.5), end{3, 0, -5};
  const auto findings = [&](const char* tool, const Vec3& up) {
    Pass pass = with_axes(model::parse_cutter(tool), {{axis * 30, axis * -4, axis, axis},
                                                      {axis * -4, end, axis, turned},
                                                      {end, end + up, turned, turned}});
    model::Toolpath path = *pass.path;
    path.moves[2].kind = model::MoveKind::rapid;
    pass.path = std::make_shared<const model::Toolpath>(path);
    return of(pass, limits(0.5));
  };
  CHECK(findings("flat:D=6,L=60", turned * 60).empty());
  // Aside it meets the wall that it has left.
  CHECK(any(findings("flat:D=6,L=60", turned * 60 + Vec3{0, 2, 0}),
            FindingKind::rapid_through_stock));
}
