#include "simulator/sweep/capsule_batch.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>

#include "tests/simulator/paths.h"
#include "tests/support/catch.h"

using namespace limitgauge;
using namespace simulator;
using model::Vec3;

namespace {

constexpr double kRadius = 3;

using Random = std::mt19937_64;
double uniform(Random& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

// Rows, scattered moves, plunges and moves of no length; rows are nearly parallel, where the
// narrowing is at its sharpest.
Pass moves_about_origin(Random& random, bool rows) {
  test::PathBuilder path({0, 0, 0});
  const double slope = uniform(random, -0.7, 0.7), step = uniform(random, 0.05, 1);
  for (int i = 0; i < 120; ++i) {
    const double side = i % 2 == 0 ? -1 : 1;
    if (rows)
      path.feed({0.05 * i - 3 + uniform(random, -0.01, 0.01), side * step, slope * side * step});
    else
      path.feed({uniform(random, -2, 2), uniform(random, -2, 2), uniform(random, -1, 1)});
    if (i % 10 == 0) path.feed({0, 0, 1}).feed({0, 0, 0.5}).feed({0, 0, 0.5});
  }
  return path.pass(test::cutter(model::CutterType::ball, 2 * kRadius, 20));
}

MoveBatch all_moves(const SweepTree& index) {
  std::vector<std::uint32_t> slots(index.size());
  std::iota(slots.begin(), slots.end(), 0U);
  MoveBatch batch;
  batch.assign(index, slots);
  return batch;
}

double least_distance(const SweepTree& index, const std::vector<std::uint32_t>& slots,
                      const Vec3& p) {
  double least = std::numeric_limits<double>::infinity();
  for (const std::uint32_t s : slots) least = std::min(least, index.distance(s, p).distance);
  return least;
}

}  // namespace

TEST_CASE("what a cube keeps holds the nearest move of each of its places",
          "[property][capsule_batch]") {
  const bool rows = GENERATE(true, false);
  Random random(rows ? 11 : 12);
  std::size_t kept_of_all = 0, all = 0;
  for (int trial = 0; trial < 150; ++trial) {
    const SweepTree index(moves_about_origin(random, rows));
    const MoveBatch batch = all_moves(index);
    // Below, beside and above the centres' ways, which are about kRadius high.
    const Vec3 middle{uniform(random, -4, 4), uniform(random, -4, 4), uniform(random, -1, 6)};
    const double h = std::pow(10, uniform(random, -2, 0.3));
    CapsuleNarrowing narrowing;
    std::vector<std::uint32_t> kept;
    const double least = narrowing.nearest(batch, middle, h);
    narrowing.keep(batch, kept);
    all += batch.size(), kept_of_all += kept.size();
    CHECK(std::abs(std::sqrt(least) - kRadius - least_distance(index, batch.slot, middle)) < 1e-12);
    for (int k = 0; k < 60; ++k) {
      const auto within = [&] {
        return k < 8 ? std::copysign(h, uniform(random, -1, 1)) : uniform(random, -h, h);
      };
      const Vec3 p = middle + Vec3{within(), within(), within()};
      // What is set aside loses by more than rounding: nothing is forgiven.
      CHECK(least_distance(index, kept, p) == least_distance(index, batch.slot, p));
    }
  }
  CHECK(kept_of_all < all / 2);
}

TEST_CASE("a cube's distances are those of its voxels", "[unit][capsule_batch]") {
  Random random(13);
  const SweepTree index(moves_about_origin(random, true));
  const MoveBatch batch = all_moves(index);
  CubeAxes axes;
  for (int k = 0; k < kCubeEdge; ++k)
    axes.x[k] = 0.3 + 0.1 * k, axes.y[k] = -0.2 + 0.1 * k, axes.z[k] = 0.1 * k - 0.1;
  const CubeDistances found = least_ball_distances(batch, batch.slot, kRadius, axes);
  std::size_t at = 0;
  for (const double z : axes.z)
    for (const double x : axes.x)
      for (const double y : axes.y)
        CHECK(std::abs(found[at++] - least_distance(index, batch.slot, {x, y, z})) < 1e-12);
}

TEST_CASE("a block gathers the nearest move of each of its places", "[property][capsule_batch]") {
  Random random(14);
  for (int trial = 0; trial < 60; ++trial) {
    const SweepTree index(moves_about_origin(random, trial % 2 == 0));
    const Vec3 middle{uniform(random, -4, 4), uniform(random, -4, 4), uniform(random, -2, 4)};
    const double h = uniform(random, 0.05, 2);
    const auto nearest = index.nearest(middle, 100);
    REQUIRE(nearest);
    std::vector<std::uint32_t> some, all;
    index.gather_rivals({middle, h, nearest->at.gradient * (nearest->at.distance + kRadius)}, some);
    index.gather(middle, 1000, all);
    CHECK(all.size() == index.size());
    for (int k = 0; k < 40; ++k) {
      const Vec3 p =
          middle + Vec3{uniform(random, -h, h), uniform(random, -h, h), uniform(random, -h, h)};
      CHECK(least_distance(index, some, p) == least_distance(index, all, p));
    }
  }
}
