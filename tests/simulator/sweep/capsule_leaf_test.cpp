#include "simulator/sweep/capsule_leaf.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <optional>
#include <random>

#include "simulator/sweep/capsule_batch.h"
#include "simulator/tolerance.h"
#include "tests/simulator/paths.h"
#include "tests/support/catch.h"

using namespace limitgauge;
using namespace simulator;
using model::Vec3;

namespace {

constexpr double kBall_mm = 3, kLeafBand_voxels = 3;

struct Leaves {
  std::mt19937_64 random{21};
  double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  }

  /// Rows whose balls meet near a slope, plunges and moves of no length among them.
  Pass rows(double voxel) {
    const double long_side = uniform(1, 30) * voxel, apart = uniform(0.5, 4) * voxel;
    const double slope = uniform(-0.8, 0.8);
    test::PathBuilder path({-long_side, 0, 0});
    for (int i = -6; i <= 6; ++i) {
      const double side = i % 2 == 0 ? -1 : 1, y = apart * i;
      path.feed({side * long_side, y, slope * side * long_side});
      path.feed({-side * long_side, y + uniform(-1, 1) * voxel, -slope * side * long_side});
      if (i % 3 == 0) path.feed({0, y, 2 * voxel}).feed({0, y, voxel}).feed({0, y, voxel});
    }
    return path.pass(test::cutter(model::CutterType::ball, 2 * kBall_mm, 20));
  }

  /// Under the balls, so that the surface or its band is in the leaf.
  LeafVoxels leaf(double voxel) {
    const double x = uniform(-0.5, 0.5) * kBall_mm, y = uniform(-0.5, 0.5) * kBall_mm;
    const double under = kBall_mm - std::sqrt(kBall_mm * kBall_mm - x * x - y * y);
    return {{x, y, under + uniform(-7, 7) * voxel}, voxel};
  }
};

double exact_at(const SweepTree& index, const std::vector<std::uint32_t>& slots, const Vec3& p) {
  double least = 1e9;
  for (const std::uint32_t s : slots) least = std::min(least, index.distance(s, p).distance);
  return least;
}

/// The worst error in voxels, of what the leaf keeps of the pass against all of it; none where the
/// leaf is not taken.
std::optional<double> worst_error(Leaves& leaves, double voxel) {
  const SweepTree index(leaves.rows(voxel));
  const LeafVoxels leaf = leaves.leaf(voxel);
  std::vector<std::uint32_t> slots(index.size()), kept;
  std::iota(slots.begin(), slots.end(), 0U);
  MoveBatch batch;
  batch.assign(index, slots);
  CapsuleNarrowing narrowing;
  narrowing.nearest(batch, leaf.middle, leaf.half_edge_mm());
  narrowing.keep(batch, kept);
  CapsuleLeaf found;
  if (!found.take(batch, kept, leaf, kBall_mm)) return std::nullopt;
  auto values = std::make_unique<CapsuleLeaf::Distances>();
  const double band = kLeafBand_voxels * voxel;
  found.distances(band, *values);
  double worst = 0;
  for (int n = 0; n < static_cast<int>(LeafVoxels::kCount); ++n) {
    const Vec3 at = Vec3{1.0 * (n / 64), 1.0 * (n / 8 % 8), 1.0 * (n % 8)} - Vec3{3.5, 3.5, 3.5};
    const double exact = exact_at(index, slots, leaf.middle + at * voxel);
    const double value = static_cast<double>((*values)[static_cast<std::size_t>(n)]);
    worst = std::max(worst, std::abs(value - std::clamp(exact, -band, band)) / voxel);
  }
  return worst;
}

}  // namespace

TEST_CASE("a leaf's distances in single precision are as near as they are said to be",
          "[property][capsule_leaf]") {
  Leaves leaves;
  double worst = 0;
  int taken = 0;
  for (int trial = 0; trial < 600; ++trial) {
    const double voxel = kBall_mm / 24 * std::pow(10, leaves.uniform(-2, 0));
    REQUIRE(CapsuleLeaf::fine_enough({{}, voxel}, kBall_mm));
    if (const auto error = worst_error(leaves, voxel)) worst = std::max(worst, *error), ++taken;
  }
  CHECK(taken > 200);
  CHECK(worst < kSinglePrecision_voxels);
  CHECK(worst > 1e-8);
}

TEST_CASE("a leaf beside a ball, whose feet leave its way, is not taken", "[unit][capsule_leaf]") {
  test::PathBuilder path({0, 0, 0});
  const SweepTree index(
      path.feed({1, 0, 0}).pass(test::cutter(model::CutterType::ball, 2 * kBall_mm, 20)));
  MoveBatch batch;
  batch.assign(index, {0});
  CapsuleLeaf leaf;
  const std::vector<std::uint32_t> all{0};
  CHECK(leaf.take(batch, all, {{0.5, 0, 0}, 0.05}, kBall_mm));
  CHECK_FALSE(leaf.take(batch, all, {{0.5, kBall_mm, kBall_mm}, 0.05}, kBall_mm));
  CHECK_FALSE(CapsuleLeaf::fine_enough({{}, 0.25}, kBall_mm));
}
