#include "simulator/instrument/dexel_patches.h"

#include <cmath>
#include <memory>
#include <random>
#include <vector>

#include "simulator/instrument/dexel_tile.h"
#include "tests/simulator/instrument/dexel_cutters.h"
#include "tests/support/catch.h"

namespace {

using namespace limitgauge;
using model::Vec3;
using simulator::DexelFrame;
using simulator::DexelPatches;
using simulator::DexelProfile;
using simulator::DexelSweep;
using simulator::DexelTile;
using simulator::test::every_cutter;

constexpr int kEdge = DexelTile::kEdge;

Vec3 line_of(const DexelFrame& frame, int line) {
  return {frame.x + line % kEdge * frame.dx, frame.y + line / kEdge * frame.dy, 0};
}

std::size_t patch_at(int line) {
  return static_cast<std::size_t>(line / kEdge / DexelPatches::kEdge * DexelPatches::kASide +
                                  line % kEdge / DexelPatches::kEdge);
}

/// From and to somewhere over the tile: long and short, level, upright and sloped moves.
struct RandomMove {
  std::mt19937_64& random;
  double wide;

  DexelSweep operator()(const DexelProfile& profile) const {
    std::uniform_real_distribution<> d(-1, 1);
    const Vec3 from{wide * d(random), wide * d(random), 3 * d(random)};
    const double far = std::uniform_int_distribution<>(0, 1)(random) ? wide : 0.3;
    Vec3 way{far * d(random), far * d(random), far * d(random)};
    const int kind = std::uniform_int_distribution<>(0, 4)(random);
    if (kind == 0) way.z = 0;
    if (kind == 1) way.x = way.y = 0;
    return {profile, from, from + way};
  }
};

/// A slope with ripples, steps and holes: what the planes must lie over.
std::unique_ptr<DexelTile> rough_tile(const DexelFrame& frame, std::mt19937_64& random) {
  std::uniform_real_distribution<> d(-1, 1);
  auto tile = std::make_unique<DexelTile>();
  const double x = d(random), y = d(random), ripple = std::max(0.0, d(random));
  for (int line = 0; line < DexelTile::kLines; ++line) {
    const Vec3 p = line_of(frame, line);
    const double step = p.x > 2 * d(random) ? 0 : 0.02,
                 top = x * p.x + y * p.y + ripple * std::sin(9 * p.x);
    if (std::abs(d(random)) > 0.99 && ripple > 0.5) continue;
    tile->set_material(line, {{-20, top + step}});
  }
  return tile;
}

}  // namespace

TEST_CASE("a move takes nothing from lines whose patch it is seen to clear", "[property][dexel]") {
  std::mt19937_64 random(81);
  std::size_t cleared = 0, taken = 0;
  for (const double spacing : {0.04, 0.3})
    for (const model::Cutter& cutter : every_cutter()) {
      const DexelProfile profile(cutter);
      const DexelFrame frame{-16 * spacing, -16 * spacing, spacing, 1.1 * spacing};
      const RandomMove move{random, 3 + 16 * spacing};
      for (int i = 0; i < 200; ++i) {
        const auto tile = rough_tile(frame, random);
        for (std::size_t k = 0; k < DexelPatches::kPatches; ++k)
          tile->patches.lay(k, tile->top.data(), frame);
        const DexelSweep sweep = move(profile);
        const std::uint32_t touched = tile->patches.touched(sweep, frame);
        for (int line = 0; line < DexelTile::kLines; ++line) {
          const Vec3 p = line_of(frame, line);
          const auto interval = sweep.interval(p.x, p.y);
          // Beyond what counts, the root of rounding at the rim of a ball.
          const bool loses = interval && interval->low < tile->top[line] - 1e-7;
          const bool may = (touched >> patch_at(line) & 1U) != 0;
          REQUIRE((may || !loses));
          taken += loses, cleared += !may;
        }
      }
    }
  CHECK(taken > 100000);
  CHECK(cleared > 100000);
}

TEST_CASE("a tile under many moves is what its lines are one by one", "[property][dexel]") {
  std::mt19937_64 random(82);
  const DexelFrame frame{-2.4, -2.4, 0.15, 0.15};
  const RandomMove move{random, 4};
  for (const model::Cutter& cutter : every_cutter()) {
    const DexelProfile profile(cutter);
    DexelTile tile;
    for (int line = 0; line < DexelTile::kLines; ++line) tile.set_material(line, {{-6, 2}});
    std::vector<double> length(DexelTile::kLines, 8);
    for (int i = 0; i < 150; ++i) {
      const DexelSweep sweep = move(profile);
      const auto removal = cut(tile, frame, sweep);
      double sum = 0, deepest = 0;
      for (int line = 0; line < DexelTile::kLines; ++line) {
        const double left = tile.length(line),
                     removed = length[static_cast<std::size_t>(line)] - left;
        REQUIRE(removed >= 0);
        sum += removed, deepest = std::max(deepest, removed);
        length[static_cast<std::size_t>(line)] = left;
        const Vec3 p = line_of(frame, line);
        // Nothing is left within the move.
        const auto interval = sweep.interval(p.x, p.y);
        if (!interval) continue;
        for (const model::Interval& m : tile.material(line))
          REQUIRE(std::min(m.high, interval->high) - std::max(m.low, interval->low) < 1e-7);
      }
      CHECK(removal.length_mm == Approx(sum).margin(1e-9));
      CHECK(removal.deepest_mm == Approx(deepest).margin(1e-9));
    }
  }
}
