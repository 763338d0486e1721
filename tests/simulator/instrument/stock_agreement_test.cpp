// The two stock models against each other: what the level set takes to be the exact material (its
// swept distances and their index), and intervals on vertical lines, which have nothing in common
// but the cutter and the path.
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <random>

#include "simulator/instrument/dexel_agreement.h"
#include "tests/simulator/instrument/dexel_cutters.h"
#include "tests/support/catch.h"

namespace {

using namespace limitgauge;
using model::BoxStock;
using model::CylinderStock;
using model::Vec3;
using simulator::compare_stocks;
using simulator::DexelStock;
using simulator::Pass;
using simulator::StockAgreement;
using simulator::StockModel;
using simulator::test::every_cutter;
using simulator::test::PathBuilder;

constexpr std::size_t kPlenty = std::size_t{2} << 30;

/// Long and short moves, level, upright, sloped and none at all, in and above the stock.
Pass job(const model::Cutter& c, unsigned seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<> x(-11, 11), y(-9, 9), z(-5, 2), step(-1, 1);
  PathBuilder b({0, 0, 12});
  Vec3 at{x(random), y(random), 12};
  b.rapid(at);
  for (int i = 0; i < 60; ++i) {
    if (i % 5 == 0) at = {x(random), y(random), z(random)};
    if (i % 5 == 1) at.z = z(random);
    if (i % 5 == 2) at.x = x(random), at.y = y(random);
    if (i % 5 > 2) at += {step(random), step(random), 0.3 * step(random)};
    b.feed(at);
    if (i % 20 == 0) b.feed(at);
  }
  return b.pass(c);
}

/// An octahedron, which no line meets but twice.
model::Stock gem() {
  auto mesh = std::make_shared<model::TriangleMesh>();
  mesh->vertices = {{10, 0, -4}, {0, 9, -4}, {-10, 0, -4}, {0, -9, -4}, {0, 0, 1}, {0, 0, -9}};
  for (std::uint32_t i = 0; i < 4; ++i) {
    mesh->triangles.push_back({i, (i + 1) % 4, 4});
    mesh->triangles.push_back({(i + 1) % 4, i, 5});
  }
  return model::MeshStock{mesh, "gem.stl", 0};
}

std::array<model::Stock, 3> stocks() {
  return {gem(), BoxStock{{-10, -8, -6}, {20, 16, 6}}, CylinderStock{{0.3, -0.2, -6}, 19, 6}};
}

StockAgreement compare(const model::Stock& raw, const model::Cutter& dexel_cutter,
                       const model::Cutter& level_set_cutter, unsigned seed, double voxel = 0.3) {
  const DexelStock dexels = DexelStock(raw, 0.23).cut(job(dexel_cutter, seed), {2}).stock;
  const StockModel level_set =
      StockModel(raw, voxel, kPlenty).cut(job(level_set_cutter, seed), {2});
  return compare_stocks(dexels, level_set, 100000, {2});
}

}  // namespace

TEST_CASE("the level set and the dexels are the same stock", "[slow][dexel][agreement]") {
  unsigned seed = 0;
  for (const model::Cutter& c : every_cutter())
    for (const model::Stock& raw : stocks()) {
      const StockAgreement a = compare(raw, c, c, ++seed);
      INFO(model::to_text(c) << " at " << a.worst_at.x << " " << a.worst_at.y << " " << a.worst_at.z
                             << " end " << a.worst_end_mm << " side " << a.worst_side_mm
                             << " volumes " << a.level_set_volume_mm3 << " " << a.dexel_volume_mm3
                             << " errors " << a.level_set_error_mm3 << " " << a.dexel_error_mm3);
      CHECK(a.ends > 4000);
      CHECK(a.worst_end_mm < 1e-6);
      CHECK(a.worst_side_mm < 1e-9);
      CHECK(a.agree());
    }
}

TEST_CASE("a cutter wider by a micrometre in one of the models is noticed",
          "[property][dexel][agreement]") {
  unsigned seed = 100;
  for (const model::Cutter& c : every_cutter()) {
    model::Cutter wider = c;
    wider.diameter_mm += 2e-3;
    if (c.type == model::CutterType::ball) wider.corner_radius_mm += 1e-3;
    const StockAgreement a = compare(stocks()[1], c, wider, ++seed);
    CHECK(a.worst_end_mm > 1e-5);
    CHECK_FALSE(a.agree());
  }
}

TEST_CASE("a missing move is noticed in the volumes alone", "[unit][dexel][agreement]") {
  const model::Cutter c = every_cutter()[0];
  const model::Stock raw = stocks()[1];
  const Pass all = job(c, 3);
  const DexelStock dexels = DexelStock(raw, 0.1).cut(all, {2}).stock;
  const Pass slot = PathBuilder({-9, -7, -5.5}).feed({9, -7, -5.5}).pass(c);
  const StockModel level_set = StockModel(raw, 0.1, kPlenty).cut(all, {2}).cut(slot, {2});
  const StockAgreement a = compare_stocks(dexels, level_set, 1, {1});
  CHECK(std::abs(a.volume_difference_mm3()) > a.dexel_error_mm3 + a.level_set_error_mm3);
}
