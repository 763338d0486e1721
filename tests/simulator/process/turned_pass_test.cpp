// Passes that lie turned in the frame of the stock: the material is that of the upright pass,
// turned.
#include <cmath>
#include <random>

#include "simulator/grid/stock_grid.h"
#include "simulator/instrument/dexel_agreement.h"
#include "simulator/instrument/turned_lines.h"
#include "simulator/stock/material.h"
#include "simulator/sweep/depth_bound.h"
#include "simulator/sweep/near_moves.h"
#include "simulator/tolerance.h"
#include "tests/simulator/instrument/dexel_cutters.h"
#include "tests/simulator/process/process_bench.h"
#include "tests/support/catch.h"

namespace {

using namespace limitgauge;
using model::Pose;
using model::Vec3;
using simulator::Pass;
using simulator::StockModel;
using simulator::test::cutter;
using simulator::test::every_cutter;
using simulator::test::PathBuilder;

constexpr std::size_t kRoomForTurned = std::size_t{2} << 30;
const model::Stock kTurnedBlock = model::BoxStock{{-10, -8, -6}, {20, 16, 6}};

std::vector<Pose> poses() {
  Pose over = model::turn_about({1, 0, 0}, 180);
  over.shift_mm = {0, 0, -6};
  Pose side = model::turn_about({0, 1, 0}, 90);
  side.shift_mm = {1, -2, 3};
  Pose oblique = model::turn_about({1, 2, 3}, 37);
  oblique.shift_mm = {0.3, 0.2, -0.7};
  return {over, side, oblique};
}

/// Level, upright, sloped moves and none at all, in and above the block.
Pass job(const model::Cutter& c, unsigned seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<> x(-11, 11), y(-9, 9), z(-5, 2), step(-1, 1);
  PathBuilder b({0, 0, 12});
  Vec3 at{x(random), y(random), 12};
  b.rapid(at);
  for (int i = 0; i < 40; ++i) {
    if (i % 5 == 0) at = {x(random), y(random), z(random)};
    if (i % 5 == 1) at.z = z(random);
    if (i % 5 == 2) at.x = x(random), at.y = y(random);
    if (i % 5 > 2) at += {step(random), step(random), 0.3 * step(random)};
    b.feed(at);
    if (i % 20 == 0) b.feed(at);
  }
  return b.pass(c);
}

Pass lying(Pass pass, const Pose& pose) {
  pass.pose = pose;
  return pass;
}

Vec3 any_place(std::mt19937_64& random) {
  std::uniform_real_distribution<> x(-11, 11), y(-9, 9), z(-7, 1);
  return {x(random), y(random), z(random)};
}

}  // namespace

TEST_CASE("what a turned pass leaves is what it leaves upright, turned", "[property][stock]") {
  std::mt19937_64 random(20261126);
  unsigned seed = 0;
  for (const model::Cutter& c : every_cutter())
    for (const Pose& pose : poses()) {
      const Pass pass = job(c, ++seed);
      const StockModel upright = StockModel(kTurnedBlock, 0.4, kRoomForTurned).cut(pass, {2});
      const StockModel turned = StockModel(model::turned(kTurnedBlock, pose), 0.4, kRoomForTurned)
                                    .cut(lying(pass, pose), {2});
      for (int n = 0; n < 400; ++n) {
        const Vec3 p = any_place(random), q = pose.point(p);
        REQUIRE(std::abs(upright.exact_value(p) - turned.exact_value(q)) < 1e-9);
        const auto a = upright.material().sample(p), b = turned.material().sample(q);
        if (a.maker == b.maker && std::abs(a.value) > 1e-3)
          REQUIRE(distance(pose.direction(a.gradient), b.gradient) < 1e-6);
        // The grid is linear between exact places: off by a bend's share of a voxel.
        if (std::abs(turned.exact_value(q)) < 0.4)
          REQUIRE(std::abs(turned.value(q) - turned.exact_value(q)) < 0.4);
      }
      // Adding up voxels of a leaning block takes seconds.
      if (!pose.keeps_axes() && seed > 3) continue;
      const double volume = turned.volume_mm3({2}), known = upright.volume_mm3({2});
      CHECK(std::abs(volume - known) < 0.02 * known);
    }
}

TEST_CASE("voxels of a turned pass are exact", "[property][stock]") {
  unsigned seed = 100;
  for (const model::Cutter& c : every_cutter())
    for (const Pose& pose : poses()) {
      const model::Stock raw = model::turned(kTurnedBlock, pose);
      const StockModel stock =
          StockModel(raw, 0.5, kRoomForTurned).cut(lying(job(c, ++seed), pose), {2});
      const simulator::Lattice& lattice = stock.grid().lattice();
      const model::Box3 box = model::bounding_box(raw);
      const double band = stock.band_mm();
      std::mt19937_64 random(seed);
      for (int n = 0; n < 400; ++n) {
        simulator::Index3 at{};
        for (int a = 0; a < 3; ++a)
          at[a] = static_cast<int>(
              std::uniform_real_distribution<>(box.low[a] - lattice.origin_mm[a],
                                               box.high[a] - lattice.origin_mm[a])(random) /
              lattice.voxel_mm);
        const Vec3 p = lattice.point(at);
        const double exact = std::clamp(stock.exact_value(p), -band, band);
        REQUIRE(std::abs(stock.value(p) - exact) < 1e-5);
      }
    }
}

TEST_CASE("moves kept for a cube hold the nearest ones of a turned pass", "[property]") {
  std::mt19937_64 random(5);
  unsigned seed = 200;
  for (const model::Cutter& c : every_cutter())
    for (const Pose& pose : poses()) {
      const simulator::SweepIndex index(lying(job(c, ++seed), pose));
      for (int n = 0; n < 30; ++n) {
        const simulator::Cube wide{pose.point(any_place(random)), 1.5};
        const simulator::Cube cube{wide.middle + Vec3{0.5, -0.5, 0.5}, 0.75};
        simulator::NearMoves far, near;
        far.gather(index, wide, 1e3);
        near.narrow(index, far, cube, 1e3);
        std::uniform_real_distribution<> in(-0.75, 0.75);
        for (int k = 0; k < 20; ++k) {
          const Vec3 p = cube.middle + Vec3{in(random), in(random), in(random)};
          const auto known = index.nearest(p, 1e3), found = near.nearest(index, p, 1e3);
          REQUIRE(known.has_value());
          REQUIRE(found.has_value());
          REQUIRE(std::abs(known->at.distance - found->at.distance) < 1e-9);
        }
      }
    }
}

TEST_CASE("the depth under a turned move is bounded in a block", "[property]") {
  std::mt19937_64 random(9);
  unsigned seed = 300;
  std::uniform_real_distribution<> part(-1, 1);
  for (const model::Cutter& c : every_cutter())
    for (const Pose& pose : poses()) {
      const simulator::SweepIndex index(lying(job(c, ++seed), pose));
      for (int n = 0; n < 60; ++n) {
        const Vec3 p = pose.point(any_place(random)), half{0.4, 0.2, 0.6};
        const auto nearest = index.nearest(p, 1e3);
        REQUIRE(nearest);
        const auto at = index.distance(nearest->slot, p);
        const double bend = index.outside_bound(nearest->slot, p, at, half);
        for (int k = 0; k < 20; ++k) {
          const Vec3 by{half.x * part(random), half.y * part(random), half.z * part(random)};
          const double there = index.distance(nearest->slot, p + by).distance;
          REQUIRE(there <= std::max(0.0, at.distance + dot(at.gradient, by) + bend) + 1e-9);
          REQUIRE(there >= at.distance + dot(at.gradient, by) - 1e-9);
        }
      }
    }
}

TEST_CASE("a stock that is turned over agrees with the lines of the setup before", "[property]") {
  unsigned seed = 400;
  for (const Pose& pose : poses())
    for (const auto type : {model::CutterType::flat, model::CutterType::ball}) {
      const Pass first = job(cutter(type, 5, 9), ++seed);
      const simulator::DexelStock lines =
          simulator::DexelStock(kTurnedBlock, 0.3).cut(first, {2}).stock;
      const model::Stock raw = model::turned(kTurnedBlock, pose);
      const StockModel turned = StockModel(raw, 0.3, kRoomForTurned).cut(lying(first, pose), {2});
      const auto agreed = compare_stocks(lines, turned, 2000, {2}, {}, pose);
      CHECK(agreed.ends > 1000);
      CHECK(agreed.agree());
      // By a hundredth of a millimetre elsewhere is seen.
      Pose off = pose;
      off.shift_mm.y += 0.01;
      const StockModel wrong = StockModel(raw, 0.3, kRoomForTurned).cut(lying(first, off), {2});
      CHECK(compare_stocks(lines, wrong, 2000, {2}, {}, pose).worst_end_mm > 1e-3);
      // The new frame's lines, and what is cut upright from then on.
      const simulator::DexelStock after = turned_lines(turned, 0.3, {2});
      CHECK(compare_stocks(after, turned, 2000, {2}).agree());
      const Pass second = job(cutter(model::CutterType::bull, 4, 9, 1), ++seed);
      const StockModel both = turned.cut(second, {2});
      CHECK(compare_stocks(after.cut(second, {2}).stock, both, 2000, {2}).agree());
    }
}

TEST_CASE("lines are the same for any number of threads", "[unit]") {
  const Pass first = job(cutter(model::CutterType::ball, 5, 9), 500);
  const Pose over = poses().front();
  const StockModel turned = StockModel(model::turned(kTurnedBlock, over), 0.3, kRoomForTurned)
                                .cut(lying(first, over), {2});
  const auto one = turned_lines(turned, 0.4, {1}), two = turned_lines(turned, 0.4, {2});
  REQUIRE(one.nx() == two.nx());
  for (int j = 0; j < one.ny(); ++j)
    for (int i = 0; i < one.nx(); ++i) {
      const auto a = one.material(i, j), b = two.material(i, j);
      REQUIRE(a.size() == b.size());
      for (std::size_t k = 0; k < a.size(); ++k)
        REQUIRE((a[k].low == b[k].low && a[k].high == b[k].high));
    }
}

TEST_CASE("a rapid through what the other side left is found, through its pocket not",
          "[unit][process]") {
  // A pocket from above, 4 mm deep of 6, over x < 0; then the block is turned over about X.
  const auto flat = cutter(model::CutterType::flat, 4, 20);
  PathBuilder pocket({-6, -6, 10});
  pocket.rapid({-6, -6, 1});
  for (double x = -6; x <= -2; x += 1)
    pocket.feed({x, -6, -4}).feed({x, 6, -4}).feed({x + 1, 6, -4});
  const Pose over = poses().front();
  const StockModel turned = StockModel(model::turned(kTurnedBlock, over), 0.3, kRoomForTurned)
                                .cut(lying(pocket.pass(flat), over), {2});
  // From below there stand 2 mm over the pocket, and 6 mm elsewhere: the block is z -6 to 0 again.
  PathBuilder through({-4, 0, 10});
  through.rapid({-4, 0, 3}).feed({-4, 0, -3}).rapid({-4, 3, -3}).rapid({-4, 3, 3}).rapid({5, 3, 3});
  const auto clear =
      simulator::test::check(turned, through.pass(cutter(model::CutterType::flat, 2, 20)));
  using simulator::FindingKind;
  // Across the web it is in material, down in the pocket it is not.
  PathBuilder low({-4, 0, 10});
  low.rapid({-4, 0, 3}).feed({-4, 0, -4}).rapid({-4, 2, -4});
  CHECK_FALSE(simulator::test::of_kind(clear, FindingKind::rapid_through_stock).empty());
  PathBuilder solid({5, 0, 10});
  solid.rapid({5, 0, -1});
  const auto small = cutter(model::CutterType::flat, 2, 20);
  CHECK(simulator::test::of_kind(simulator::test::check(turned, solid.pass(small)),
                                 FindingKind::rapid_through_stock)
            .size() == 1);
  // In from the side, through the pocket's open end below the web.
  PathBuilder beside({-4, 20, 10});
  beside.rapid({-4, 20, -5}).rapid({-4, 9, -5});
  CHECK(simulator::test::of_kind(simulator::test::check(turned, beside.pass(small)),
                                 FindingKind::rapid_through_stock)
            .empty());
}
