#include "simulator/instrument/dexel_stock.h"

#include <array>
#include <atomic>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <stdexcept>

#include "model/base/error.h"
#include "tests/simulator/instrument/dexel_cutters.h"
#include "tests/support/catch.h"

namespace {

using namespace limitgauge;
using model::BoxStock;
using model::CutterType;
using model::CylinderStock;
using model::Vec3;
using simulator::DexelStock;
using simulator::Pass;
using simulator::test::cutter;
using simulator::test::every_cutter;
using simulator::test::PathBuilder;

constexpr double kPi = std::numbers::pi;
const model::Stock kDexelBlock = BoxStock{{-15, -10, -8}, {30, 20, 8}};

struct Taken {
  double volume, error;
};

Taken removed(double spacing, const Pass& pass) {
  const DexelStock raw(kDexelBlock, spacing);
  const DexelStock after = raw.cut(pass, {2}).stock;
  return {raw.volume_mm3() - after.volume_mm3(), after.volume_error_mm3()};
}

// Within the error that the model states of itself, which is no excuse: a wall along the lines may
// be placed half a spacing beside where it is, and `outline` is the walls' length times the depth
// there. At R/30 all are within 0.1 %.
void check(const Pass& pass, double formula, double outline) {
  for (const double spacing : {0.21, 0.1}) {
    const Taken taken = removed(spacing, pass);
    INFO("spacing " << spacing << " stated error " << taken.error);
    CHECK(std::abs(taken.volume - formula) <= taken.error);
    CHECK(std::abs(taken.volume - formula) <= 0.5 * outline * spacing);
    if (spacing == 0.1) CHECK(taken.volume == Approx(formula).epsilon(1e-3));
  }
}

double segment_area(double r, double d) {
  return r * r * std::acos((r - d) / r) - (r - d) * std::sqrt(2 * r * d - d * d);
}

Pass pocket(const model::Cutter& c) {
  PathBuilder b({-6, -4, 5});
  b.feed({-6, -4, -3});
  for (double y = -4; y <= 4; y += 2) b.feed({-6, y, -3}).feed({6, y, -3}).feed({-6, y, -3});
  // The rows leave scallops along their far ends.
  return b.feed({6, 4, -3}).feed({6, -4, -3}).pass(c);
}

Pass wanderings(const model::Cutter& c, int moves, unsigned seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<> x(-14, 14), y(-9, 9), z(-6, 2);
  PathBuilder b({0, 0, 5});
  for (int i = 0; i < moves; ++i) {
    const Vec3 to{x(random), y(random), z(random)};
    i % 7 == 0 ? b.rapid(to) : b.feed(to);
  }
  return b.pass(c);
}

}  // namespace

TEST_CASE("dexels of raw stock have its volume", "[unit][dexel]") {
  CHECK(DexelStock(kDexelBlock, 0.3).volume_mm3() == Approx(30 * 20 * 8).epsilon(1e-12));
  CHECK(DexelStock(kDexelBlock, 0.3).volume_error_mm3() == Approx(0).margin(1e-9));
  CHECK(DexelStock(kDexelBlock, 0.3).surface_area_mm2() ==
        Approx(2 * (600 + 240 + 160)).epsilon(1e-12));
  const DexelStock bar(CylinderStock{{1, 2, -3}, 20, 10}, 0.1);
  CHECK(std::abs(bar.volume_mm3() - kPi * 100 * 10) <= bar.volume_error_mm3());
  CHECK(bar.volume_mm3() == Approx(kPi * 1000).epsilon(1e-3));
  CHECK(DexelStock(kDexelBlock, 0.3).spacing_mm() <= 0.3);
}

TEST_CASE("a spacing or a stock that cannot be is refused", "[unit][dexel]") {
  for (const double spacing : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()})
    CHECK_THROWS_AS(DexelStock(kDexelBlock, spacing), std::invalid_argument);
  CHECK_THROWS_AS(DexelStock(BoxStock{{0, 0, 0}, {1, 0, 1}}, 0.1), std::invalid_argument);
}

TEST_CASE("dexels lose the volumes of the formulas", "[unit][dexel]") {
  const model::Cutter flat = cutter(CutterType::flat, 6, 20),
                      ball = cutter(CutterType::ball, 6, 20);
  const double r = 3;
  SECTION("slot") {
    check(PathBuilder({-8, 0, -2}).feed({8, 0, -2}).pass(flat), 2 * (16 * 6 + kPi * r * r),
          2 * (32 + 6 * kPi));
  }
  SECTION("plunge") {
    check(PathBuilder({0, 0, 5}).feed({0, 0, -4}).pass(flat), 4 * kPi * r * r, 4 * 6 * kPi);
  }
  SECTION("pocket") {
    check(pocket(flat), 3 * (12 * 8 + 2 * 3 * 20 + kPi * r * r), 3 * (40 + 6 * kPi));
  }
  SECTION("ramp") {
    // From 0 down to −4 over 16 mm. In sections across the move: the floor under the trailing edge
    // (the cutter goes on to lower places) rises over the disc's half behind each line.
    // Volume = swept area of a flat disc whose level sinks: depth at a line is 4/16 of the last
    // place along the move that covers it.
    double volume = 0;
    constexpr int kStrips = 4000;
    for (int i = 0; i < kStrips; ++i) {
      const double v = -r + 2 * r * (i + 0.5) / kStrips, w = std::sqrt(r * r - v * v);
      // Last place s = min(16, u + w), for u from −w to 16 + w.
      volume += 2 * r / kStrips * 0.25 * (16.0 * 16 / 2 + 2 * w * 16);
    }
    check(PathBuilder({-8, 0, 0}).feed({8, 0, -4}).pass(flat), volume, 2 * (32 + 6 * kPi));
  }
  SECTION("full circle as chords") {
    PathBuilder b({5, 0, -2});
    constexpr int kChords = 720;
    for (int i = 1; i <= kChords; ++i)
      b.feed({5 * std::cos(2 * kPi * i / kChords), 5 * std::sin(2 * kPi * i / kChords), -2});
    // The chords' sagitta, 5 (1 − cos(π/720)) = 5e-5 mm, is far below the error.
    check(b.pass(flat), 2 * kPi * (64 - 4), 2 * 2 * kPi * (8 + 2));
  }
  SECTION("ball slot") {
    const double depth = 2, cap = kPi * depth * depth * (r - depth / 3);
    check(PathBuilder({-8, 0, -depth}).feed({8, 0, -depth}).pass(ball),
          16 * segment_area(r, depth) + cap, depth * 32);
  }
}

TEST_CASE("material above the flutes stays on its lines", "[unit][dexel]") {
  // A flat with flutes 2 mm long under the surface: a tunnel, then a second one below it.
  const model::Cutter c = cutter(CutterType::flat, 6, 2);
  const DexelStock raw(kDexelBlock, 0.5);
  const auto one = raw.cut(PathBuilder({-5, 0, -4}).feed({5, 0, -4}).pass(c), {1});
  const int i = raw.nx() / 2, j = raw.ny() / 2;
  REQUIRE(one.stock.material(i, j).size() == 2);
  CHECK(one.stock.material(i, j)[0].high == -4);
  CHECK(one.stock.material(i, j)[1].low == -2);
  CHECK(one.removal.moves[0].axial_mm == 2);
  const auto two = one.stock.cut(PathBuilder({-5, 0, -7}).feed({5, 0, -7}).pass(c), {1});
  REQUIRE(two.stock.material(i, j).size() == 3);
  // Wide open: everything above −7.5 goes, from all three.
  const model::Cutter tall = cutter(CutterType::flat, 6, 20);
  const auto open = two.stock.cut(PathBuilder({-5, 0, -7.5}).feed({5, 0, -7.5}).pass(tall), {1});
  REQUIRE(open.stock.material(i, j).size() == 1);
  CHECK(open.removal.moves[0].axial_mm == Approx(7.5 - 4));
  CHECK(open.stock.volume_mm3() ==
        Approx(raw.volume_mm3() - one.removal.totals.volume_mm3 - two.removal.totals.volume_mm3 -
               open.removal.totals.volume_mm3));
}

TEST_CASE("dexels and removals are the same for any number of threads", "[property][dexel]") {
  const DexelStock raw(kDexelBlock, 0.15);
  for (const model::Cutter& c : every_cutter()) {
    const Pass pass = wanderings(c, 60, 5);
    const auto one = raw.cut(pass, {1}), three = raw.cut(pass, {3});
    REQUIRE(one.stock.volume_mm3() == three.stock.volume_mm3());
    for (std::size_t i = 0; i < one.removal.moves.size(); ++i) {
      REQUIRE(one.removal.moves[i].volume_mm3 == three.removal.moves[i].volume_mm3);
      REQUIRE(one.removal.moves[i].radial_mm == three.removal.moves[i].radial_mm);
      REQUIRE(one.removal.moves[i].axial_mm == three.removal.moves[i].axial_mm);
    }
  }
}

TEST_CASE("what is left does not depend on the order of moves", "[property][dexel]") {
  const DexelStock raw(kDexelBlock, 0.3);
  for (const model::Cutter& c : every_cutter()) {
    const Pass pass = wanderings(c, 40, 6);
    PathBuilder back(pass.path->moves.back().to);
    for (std::size_t i = pass.path->moves.size(); i-- > 0;) back.feed(move_from(*pass.path, i));
    const DexelStock a = raw.cut(pass, {2}).stock, b = raw.cut(back.pass(c), {2}).stock;
    for (int j = 0; j < a.ny(); ++j)
      for (int i = 0; i < a.nx(); ++i) {
        const auto ma = a.material(i, j), mb = b.material(i, j);
        REQUIRE(ma.size() == mb.size());
        for (std::size_t k = 0; k < ma.size(); ++k) {
          // Where a side stands upright, the root of rounding along Z.
          REQUIRE(ma[k].low == Approx(mb[k].low).margin(1e-6));
          REQUIRE(ma[k].high == Approx(mb[k].high).margin(1e-6));
        }
      }
  }
}

TEST_CASE("cutting dexels stops when told to and says how far it is", "[unit][dexel]") {
  const DexelStock raw(kDexelBlock, 0.3);
  const Pass pass = wanderings(cutter(CutterType::ball, 6, 20), 40, 7);
  const std::atomic<bool> stop{true};
  CHECK_THROWS_AS(raw.cut(pass, {2, &stop, {}}), model::Interrupted);
  double last = 0;
  raw.cut(pass, {1, nullptr, [&](double fraction) {
                   CHECK(fraction >= last);
                   last = fraction;
                 }});
  CHECK(last == 1);
}
