#include <algorithm>
#include <cmath>
#include <random>

#include "model/base/error.h"
#include "simulator/grid/stock_grid.h"
#include "simulator/stock/column_tops.h"
#include "simulator/stock/stock_model.h"
#include "tests/simulator/mesh/mesh_check.h"
#include "tests/simulator/paths.h"
#include "tests/support/catch.h"

namespace {

using namespace limitgauge;
using model::BoxStock;
using model::CutterType;
using simulator::StockModel;
using simulator::StockPoint;
using simulator::test::cutter;
using simulator::test::PathBuilder;
using simulator::test::raster;

constexpr std::size_t kTiledBytes = std::size_t{2} << 30;
// Too little for the 40 MiB of the whole, enough for tiles.
constexpr std::size_t kLittle = 12 << 20;
constexpr double kVoxel = 0.05;

const model::Stock kStock = BoxStock{{-15, -10, -8}, {30, 20, 8}};

simulator::Pass rows(const model::Cutter& c) {
  return raster(c, 5, 1.3, 0.7, [](double x, double y) {
    return -2.0 + 0.6 * std::sin(0.7 * x) + 0.4 * std::cos(0.9 * y);
  });
}

StockModel cut_in(std::size_t limit, unsigned threads = 2) {
  StockModel stock(kStock, kVoxel, limit, {threads});
  stock = std::move(stock).cut(rows(cutter(CutterType::flat, 4, 20)), {threads});
  return std::move(stock).cut(
      PathBuilder({-12, 7, -4}).feed({12, 3, -6}).pass(cutter(CutterType::ball, 3, 20)), {threads});
}

bool same(const std::vector<StockPoint>& a, const std::vector<StockPoint>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& p, const auto& q) {
    return p.position == q.position && p.residual_mm == q.residual_mm;
  });
}

}  // namespace

TEST_CASE("tiles give what the whole grid gives", "[slow][tiled_stock]") {
  const StockModel whole = cut_in(kTiledBytes), tiled = cut_in(kLittle);
  REQUIRE(whole.tiles() == 0);
  REQUIRE(whole.coarsening() == 1);
  REQUIRE(tiled.tiles() > 3);
  REQUIRE(tiled.coarsening() > 1);
  CHECK(tiled.memory_bytes() <= kLittle);
  CHECK(tiled.volume_mm3() == whole.volume_mm3());

  const auto points = whole.surface_points({2});
  REQUIRE(points.size() > 100000);
  CHECK(same(points, tiled.surface_points({2})));
  const model::Box3 region{{-9, -6, -5}, {3, 7, 1}};
  const auto some = whole.surface_points(region, {2});
  CHECK(some.size() > 10000);
  CHECK(some.size() < points.size());
  CHECK(same(some, tiled.surface_points(region, {2})));

  const auto tops = whole.column_tops(), tiled_tops = tiled.column_tops();
  CHECK(tops.nx == tiled_tops.nx);
  CHECK(tops.corner_mm == tiled_tops.corner_mm);
  CHECK(tops.top_mm == tiled_tops.top_mm);

  std::mt19937_64 random(5);
  std::uniform_real_distribution<> x(-15, 15), y(-10, 10), z(-8, 0.5);
  for (int i = 0; i < 5000; ++i) {
    const model::Vec3 p{x(random), y(random), z(random)};
    // Single precision of values up to the band of 0.15 mm.
    CHECK(tiled.value(p) == Approx(whole.value(p)).margin(3e-8));
    CHECK(tiled.exact_value(p) == whole.exact_value(p));
  }
}

TEST_CASE("points come in the same order some at a time", "[property][tiled_stock]") {
  const StockModel stock =
      StockModel(kStock, 0.2, kTiledBytes).cut(rows(cutter(CutterType::bull, 4, 20, 1)), {2});
  const model::Box3 region{{-9, -6, -5}, {3, 7, 1}};
  std::vector<StockPoint> streamed;
  std::size_t calls = 0;
  stock.visit_surface_points(region,
                             [&](std::span<const StockPoint> some) {
                               streamed.insert(streamed.end(), some.begin(), some.end());
                               ++calls;
                             },
                             {2});
  CHECK(calls > 10);
  CHECK(same(streamed, stock.surface_points(region, {1})));
}

TEST_CASE("what is drawn of a tiled stock is a closed coarser surface", "[slow][tiled_stock]") {
  const StockModel tiled = cut_in(kLittle);
  const auto surface = tiled.surface({2});
  CHECK(surface.voxel_mm >= Approx(tiled.coarsening() * kVoxel));
  CHECK(simulator::test::faults(surface.mesh).none());
  // Of second order in the voxel: the surface of 2000 mm² is off by less than its square.
  CHECK(simulator::test::enclosed_volume(surface.mesh) ==
        Approx(tiled.volume_mm3()).margin(2000 * surface.voxel_mm * surface.voxel_mm));
}

TEST_CASE("a stock that is let go of is cut where it stands", "[unit][tiled_stock]") {
  const simulator::Pass pass = rows(cutter(CutterType::ball, 4, 20));
  StockModel stock(kStock, 0.25, kTiledBytes);
  const auto* grid = &stock.grid();
  const StockModel copy_cut = stock.cut(pass, {2});
  CHECK(&stock.grid() == grid);
  CHECK(stock.volume_mm3() == Approx(4800).epsilon(1e-7));
  const StockModel shared = stock;  // so the level set is not alone
  const StockModel moved = std::move(stock).cut(pass, {2});
  CHECK(shared.volume_mm3() == Approx(4800).epsilon(1e-7));
  CHECK(moved.volume_mm3() == copy_cut.volume_mm3());
  CHECK(same(moved.surface_points({2}), copy_cut.surface_points({2})));
}

TEST_CASE("work on tiles shows its progress and stops when asked to", "[slow][tiled_stock]") {
  std::atomic<double> furthest = 0;
  std::atomic<int> reports = 0;
  model::RunControl control{1};
  control.progress = [&](double fraction) {
    CHECK(fraction >= 0);
    CHECK(fraction <= 1 + 1e-12);
    furthest = std::max(furthest.load(), fraction);
    ++reports;
  };
  StockModel stock(kStock, kVoxel, kLittle, control);
  CHECK(furthest == Approx(1));
  CHECK(reports > 20);

  std::atomic<bool> stop = false;
  model::RunControl stopping{2, &stop};
  stopping.progress = [&](double fraction) { stop = stop || fraction > 0.3; };
  const simulator::Pass pass = rows(cutter(CutterType::ball, 4, 20));
  CHECK_THROWS_AS(stock.cut(pass, stopping), model::Interrupted);
  // Of the many cells along the block's edges a sample is worked out exactly.
  CHECK(stock.volume_mm3() == Approx(4800).epsilon(1e-6));
  stop = false;
  CHECK_THROWS_AS(stock.surface_points(stopping), model::Interrupted);
}
