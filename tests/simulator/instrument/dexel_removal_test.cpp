#include "simulator/instrument/dexel_removal.h"

#include <cmath>
#include <numbers>
#include <random>

#include "simulator/instrument/dexel_stock.h"
#include "tests/simulator/instrument/dexel_cutters.h"
#include "tests/support/catch.h"

namespace {

using namespace limitgauge;
using model::BoxStock;
using model::CutterType;
using model::Vec3;
using simulator::DexelStock;
using simulator::Pass;
using simulator::Removal;
using simulator::test::cutter;
using simulator::test::every_cutter;
using simulator::test::PathBuilder;

const model::Stock kBlock = BoxStock{{-15, -10, -8}, {30, 20, 8}};

Removal take(const Pass& pass, double spacing = 0.1) {
  return DexelStock(kBlock, spacing).cut(pass, {2}).removal;
}

}  // namespace

TEST_CASE("in a straight slot each move takes its feed times the slot's section", "[unit][dexel]") {
  const model::Cutter flat = cutter(CutterType::flat, 6, 20);
  PathBuilder b({-8, 0, -2});
  for (int i = 1; i <= 32; ++i) b.feed({-8 + 0.5 * i, 0, -2});
  const Removal removal = take(b.pass(flat));
  // Once the whole disc is in. 0.5 mm is five columns of lines, 60 lines wide: exact.
  for (std::size_t i = 1; i < removal.moves.size(); ++i) {
    CHECK(removal.moves[i].volume_mm3 == Approx(0.5 * 6 * 2).epsilon(1e-9));
    CHECK(removal.moves[i].rate_mm3_min == Approx(1000 * 6 * 2).epsilon(1e-9));
    CHECK(removal.moves[i].axial_mm == Approx(2).epsilon(1e-12));
    CHECK(removal.moves[i].radial_mm == Approx(6).margin(0.1));
  }
  // The first move plunges too; over a stretch of ten spacings it still weighs most.
  CHECK(removal.totals.largest_rate_move == 0);
  CHECK(removal.totals.air_length_mm == 0);
  CHECK(removal.totals.spacing_mm == Approx(0.1));
}

TEST_CASE("engagement of a half immersed flat is its radius and the depth", "[unit][dexel]") {
  const model::Cutter flat = cutter(CutterType::flat, 6, 20);
  const auto path = [&](double angle, double side) {
    const Vec3 a{std::cos(angle), std::sin(angle), 0}, n{-a.y, a.x, 0};
    const Vec3 off = n * side - Vec3{0, 0, 1.5};
    return PathBuilder(a * -5.0 + off).feed(a * 5.0 + off).pass(flat);
  };
  for (const double angle : {0.0, 0.4, 1.1, std::numbers::pi / 2, 3.0}) {
    const DexelStock slot = DexelStock(kBlock, 0.1).cut(path(angle, 0), {2}).stock;
    const auto half = slot.cut(path(angle, 3), {2}).removal.moves[0];
    CHECK(half.axial_mm == 1.5);
    // The slot's own ends are round: beside them the cutter's whole front half is new.
    CHECK(half.radial_mm >= 3 - 0.1);
    CHECK(half.volume_mm3 > 0);
  }
  // With a slot longer than the move its width is the half diameter, to a spacing.
  const DexelStock slot = DexelStock(kBlock, 0.1)
                              .cut(PathBuilder({-11, 0, -1.5}).feed({11, 0, -1.5}).pass(flat), {2})
                              .stock;
  const auto half =
      slot.cut(PathBuilder({-6, 3, -1.5}).feed({6, 3, -1.5}).pass(flat), {2}).removal.moves[0];
  CHECK(half.radial_mm == Approx(3).margin(0.1));
}

TEST_CASE("the width of a move of one row of lines is that of the row", "[unit][dexel]") {
  // Along y over a block one line deep: all places across it lie on one row.
  const DexelStock plate(BoxStock{{-15, 0, -8}, {30, 0.1, 8}}, 0.1);
  const Pass pass = PathBuilder({0, -9, -1}).feed({0, 9, -1}).pass(cutter(CutterType::flat, 6, 20));
  CHECK(plate.cut(pass, {1}).removal.moves[0].radial_mm == Approx(6).margin(0.1));
}

TEST_CASE("a plunge engages the whole cutter", "[unit][dexel]") {
  const Removal removal =
      take(PathBuilder({1, 2, 5}).feed({1, 2, -4}).pass(cutter(CutterType::flat, 6, 20)));
  CHECK(removal.moves[0].radial_mm == Approx(6).margin(0.1));
  CHECK(removal.moves[0].axial_mm == 4);
}

TEST_CASE("a move repeated cuts air, and rapids in the air are not counted", "[property][dexel]") {
  std::mt19937_64 random(9);
  std::uniform_real_distribution<> x(-14, 14), y(-9, 9), z(-6, 0);
  for (const model::Cutter& c : every_cutter()) {
    for (int i = 0; i < 20; ++i) {
      const Vec3 a{x(random), y(random), z(random)}, b{x(random), y(random), z(random)};
      const Removal removal =
          take(PathBuilder(a).feed(b).feed(a).feed(b).rapid({0, 0, 9}).rapid(b).pass(c), 0.3);
      REQUIRE(removal.moves[0].volume_mm3 > 0);
      REQUIRE(removal.moves[1].volume_mm3 == 0);
      REQUIRE(removal.moves[2].volume_mm3 == 0);
      REQUIRE(removal.totals.air_length_mm == Approx(2 * distance(a, b)));
      REQUIRE(removal.totals.air_time_s == Approx(2 * distance(a, b) / 1000 * 60));
    }
  }
}

TEST_CASE("what the moves take adds up to what is missing", "[property][dexel]") {
  std::mt19937_64 random(10);
  std::uniform_real_distribution<> x(-14, 14), y(-9, 9), z(-6, 2);
  for (const model::Cutter& c : every_cutter()) {
    PathBuilder b({0, 0, 5});
    for (int i = 0; i < 80; ++i) b.feed({x(random), y(random), z(random)});
    const DexelStock raw(kBlock, 0.2);
    const auto cut = raw.cut(b.pass(c), {2});
    const double missing = raw.volume_mm3() - cut.stock.volume_mm3();
    // Rounding of each line's sum, and slivers thinner than 1e-9 mm.
    REQUIRE(cut.removal.totals.volume_mm3 == Approx(missing).epsilon(1e-9));
  }
}

TEST_CASE("splitting a move splits its volume", "[property][dexel]") {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<> x(-14, 14), y(-9, 9), z(-6, 0);
  for (const model::Cutter& c : every_cutter())
    for (int i = 0; i < 10; ++i) {
      const Vec3 from{x(random), y(random), z(random)}, to{x(random), y(random), z(random)};
      const Removal whole = take(PathBuilder(from).feed(to).pass(c), 0.3);
      PathBuilder split(from);
      for (int k = 1; k <= 7; ++k) split.feed(lerp(from, to, k / 7.0));
      const Removal parts = take(split.pass(c), 0.3);
      // 7,000 lines whose ends may differ by rounding, at upright sides by its root, 1e-8 mm.
      REQUIRE(parts.totals.volume_mm3 == Approx(whole.totals.volume_mm3).epsilon(1e-7));
      REQUIRE(parts.totals.largest_axial_mm <= whole.totals.largest_axial_mm + 1e-6);
    }
}

TEST_CASE("moves apart from each other take the same in either order", "[property][dexel]") {
  const model::Cutter ball = cutter(CutterType::ball, 4, 20);
  const Vec3 a{-9, -5, -2}, b{-3, -4, -3}, c{4, 3, -1}, d{9, 6, -3};
  const Removal one = take(PathBuilder(a)
                               .feed(b)
                               .rapid({0, 0, 20})
                               .rapid(c + Vec3{0, 0, 20})
                               .rapid(c)
                               .feed(d)
                               .pass(ball));
  const Removal two = take(PathBuilder(c)
                               .feed(d)
                               .rapid({0, 0, 20})
                               .rapid(a + Vec3{0, 0, 20})
                               .rapid(a)
                               .feed(b)
                               .pass(ball));
  // Without the plunge into the second place, which a rapid takes in both.
  CHECK(one.moves[0].volume_mm3 ==
        Approx(two.moves[3].volume_mm3 + two.moves[4].volume_mm3).epsilon(1e-12));
  CHECK(two.moves[0].volume_mm3 ==
        Approx(one.moves[3].volume_mm3 + one.moves[4].volume_mm3).epsilon(1e-12));
}

TEST_CASE("the largest rate is that of a stretch, not of the luck of a short move",
          "[unit][dexel]") {
  // A slot in moves of a twentieth of a spacing: a single one crosses a few lines or none.
  const model::Cutter flat = cutter(CutterType::flat, 6, 20);
  PathBuilder b({-8, 0, 5});
  b.rapid({-8, 0, -2});
  for (int i = 1; i <= 1200; ++i) b.feed({-8 + 0.01 * i, 0, -2});
  const Removal removal = take(b.pass(flat), 0.2);
  double luck = 0;
  for (const auto& move : removal.moves) luck = std::max(luck, move.rate_mm3_min);
  CHECK(luck > 1.5 * 12000);
  CHECK(removal.totals.largest_rate_mm3_min == Approx(12000).epsilon(0.1));
}

TEST_CASE("the spacing follows the voxel until the work would be too much", "[unit][dexel]") {
  const model::Cutter ball = cutter(CutterType::ball, 6, 20);
  const auto pass = [&](int moves) {
    PathBuilder b({0, 0, 0});
    for (int i = 0; i < moves; ++i) b.feed({i % 2 * 0.1, 0, 0});
    return b.pass(ball);
  };
  const model::Stock large = BoxStock{{0, 0, 0}, {300, 300, 80}};
  CHECK(simulator::removal_spacing_mm(0.1, kBlock, {pass(10)}) == 0.1);
  // 300 × 300 mm at four million lines.
  CHECK(simulator::removal_spacing_mm(0.05, large, {pass(10)}) == Approx(0.15));
  // Two million moves that visit π 9 mm² each, at 1.5e9 visits.
  CHECK(simulator::removal_spacing_mm(0.01, kBlock, {pass(2000000)}) ==
        Approx(std::sqrt(2e6 * (std::numbers::pi * 9 + 0.6) / 1.5e9)));
  CHECK(simulator::removal_spacing_mm(5, kBlock, {pass(10)}) == 30.0 / 20);
  // Two tiles' worth of lines before and after, and 32 bytes a move.
  CHECK(simulator::removal_bytes(kBlock, 0.1, 1000000) > 32e6 + 2 * 60000 * 16);
}
