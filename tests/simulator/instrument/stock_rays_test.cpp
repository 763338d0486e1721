#include "simulator/instrument/stock_rays.h"

#include <cmath>
#include <random>

#include "tests/simulator/paths.h"
#include "tests/support/catch.h"
#include "tests/support/solid_meshes.h"

namespace {

using namespace limitgauge;
using model::CutterType;
using model::Vec3;
using simulator::StockModel;
using simulator::StockRays;
using simulator::test::cutter;
using simulator::test::PathBuilder;
using simulator::test::raster;

constexpr std::size_t kPlentyOfRays = std::size_t{2} << 30, kLittle = 12 << 20;
/// Half of what a ray may pass over, and rounding: nothing here is finer.
constexpr double kSame_mm = 2 * limitgauge::simulator::kLeastFeature_mm;

StockModel cut_in(const model::Stock& raw, double voxel_mm, std::size_t limit) {
  StockModel stock(raw, voxel_mm, limit, {2});
  const auto wave = [](double x, double y) {
    return -2.0 + 0.6 * std::sin(0.7 * x) + 0.4 * std::cos(0.9 * y);
  };
  stock = std::move(stock).cut(raster(cutter(CutterType::flat, 4, 20), 5, 1.3, 0.7, wave), {2});
  stock = std::move(stock).cut(raster(cutter(CutterType::ball, 3, 20), 5, 0.8, 0.5, wave), {2});
  const auto drill = cutter(CutterType::flat, 0.3, 20);
  return std::move(stock).cut(PathBuilder({1, 1, 5})
                                  .feed({1, 1, -6})
                                  .feed({1, 1, 5})
                                  .feed({1.35, 1, 5})
                                  .feed({1.35, 1, -7})
                                  .pass(drill),
                              {2});
}

/// Every point of the run is on its side, and the exact material changes sides at its end.
void check_run(const StockModel& stock, const Vec3& from, const Vec3& along, double limit_mm,
               const StockRays::Run& run) {
  const double side = run.material ? -1 : 1;
  CAPTURE(from.x, from.y, from.z, along.x, along.y, along.z, run.length_mm, run.material);
  REQUIRE(run.length_mm <= limit_mm);
  constexpr int kLooks = 200;
  double least = 0;
  for (int k = 0; k < kLooks; ++k)
    least = std::min(least, side * stock.exact_value(from + along * (run.length_mm * k / kLooks)));
  CHECK(least >= -kSame_mm);
  if (run.ends) {
    CHECK(run.error_mm <= limitgauge::simulator::kLeastFeature_mm);
    CHECK(std::abs(stock.exact_value(from + along * run.length_mm)) <= kSame_mm);
    CHECK(side * stock.exact_value(from + along * (run.length_mm + kSame_mm)) <= kSame_mm);
  } else {
    CHECK(run.length_mm == limit_mm);
  }
}

Vec3 direction(std::mt19937& random) {
  std::normal_distribution<double> normal;
  return normalized(Vec3{normal(random), normal(random), normal(random)});
}

}  // namespace

TEST_CASE("rays end where the exact material does, in every kind of stock",
          "[property][stock_rays]") {
  const model::Stock block = model::BoxStock{{-7, -7, -8}, {14, 14, 8}};
  const model::Stock bar = model::CylinderStock{{0, 0, -8}, 14, 8};
  const model::Stock mesh = tests::mesh_stock(tests::box_mesh({-7, -7, -8}, {14, 14, 8}));
  for (const model::Stock& raw : {block, bar, mesh}) {
    const StockModel stock = cut_in(raw, 0.25, kPlentyOfRays);
    const StockRays rays(stock);
    std::mt19937 random(7);
    std::uniform_real_distribution<double> across(-8, 8), up(-8, 1);
    for (int k = 0; k < 300; ++k) {
      const Vec3 from{across(random), across(random), up(random)}, along = direction(random);
      check_run(stock, from, along, 12, rays.run(from, along, 12));
    }
  }
}

TEST_CASE("the voxel, and whether the stock is tiled, change no ray",
          "[property][stock_rays][slow]") {
  const model::Stock block = model::BoxStock{{-15, -10, -8}, {30, 20, 8}};
  const StockModel fine = cut_in(block, 0.05, kPlentyOfRays),
                   coarse = cut_in(block, 0.5, kPlentyOfRays), tiled = cut_in(block, 0.05, kLittle);
  REQUIRE(tiled.tiles() > 1);
  std::mt19937 random(8);
  std::uniform_real_distribution<double> across(-6, 6), up(-5, 0.5);
  for (int k = 0; k < 300; ++k) {
    const Vec3 from{across(random), across(random), up(random)}, along = direction(random);
    const auto a = StockRays(fine).run(from, along, 12), b = StockRays(coarse).run(from, along, 12),
               c = StockRays(tiled).run(from, along, 12);
    CAPTURE(k, a.length_mm, b.length_mm, c.length_mm);
    CHECK(a.material == b.material);
    CHECK(a.material == c.material);
    CHECK(a.length_mm == Approx(b.length_mm).margin(kSame_mm));
    CHECK(a.length_mm == Approx(c.length_mm).margin(kSame_mm));
  }
}

TEST_CASE("a fin and a gap of two micrometres are seen whatever the voxel is",
          "[unit][stock_rays]") {
  const double w = 0.002;
  for (const double voxel : {0.1, 0.5}) {
    StockModel stock(model::BoxStock{{-10, -10, -8}, {20, 20, 8}}, voxel, kPlentyOfRays, {2});
    stock = std::move(stock).cut(PathBuilder({-2 - w / 2, -15, -5})
                                     .feed({-2 - w / 2, 15, -5})
                                     .feed({-2 - w / 2, 15, 5})
                                     .feed({2 + w / 2, 15, 5})
                                     .feed({2 + w / 2, 15, -5})
                                     .feed({2 + w / 2, -15, -5})
                                     .pass(cutter(CutterType::flat, 4, 20)),
                                 {2});
    const StockRays rays(stock);
    const auto over = rays.run({0, 1, -5}, {0, 0, 1}, 30);
    CHECK(over.material);
    CHECK(over.length_mm == Approx(5).margin(kSame_mm));
    const auto beside = rays.run({-3, 1, -2}, {1, 0, 0}, 30);
    CHECK_FALSE(beside.material);
    CHECK(beside.length_mm == Approx(3 - w / 2).margin(kSame_mm));
    const auto through = rays.run({0, 1, -2}, {1, 0, 0}, 30);
    CHECK(through.length_mm == Approx(w / 2).margin(kSame_mm));
    // The gap is the fin's negative: a slitting pass of that width, 4 mm deep.
    const StockModel slit =
        StockModel(model::BoxStock{{-10, -10, -8}, {20, 20, 8}}, voxel, kPlentyOfRays)
            .cut(PathBuilder({0.013, -15, -4})
                     .feed({0.013, 15, -4})
                     .pass(cutter(CutterType::flat, w, 20)),
                 {2});
    const auto in = StockRays(slit).run({0.013, 1, 0}, {0, 0, -1}, 30);
    CHECK_FALSE(in.material);
    CHECK(in.length_mm == Approx(4).margin(kSame_mm));
    const auto aside = StockRays(slit).run({-5, 1, -2}, {1, 0, 0}, 30);
    CHECK(aside.length_mm == Approx(5.013 - w / 2).margin(kSame_mm));
  }
}

TEST_CASE("a ray that keeps close to a wall goes all its way", "[unit][stock_rays]") {
  const StockModel stock =
      StockModel(model::BoxStock{{-10, -10, -8}, {20, 20, 8}}, 0.25, kPlentyOfRays)
          .cut(PathBuilder({0, -15, -5}).feed({0, 15, -5}).pass(cutter(CutterType::flat, 4, 20)),
               {2});
  const StockRays rays(stock);
  for (const double off : {1e-5, 1e-3, 0.02}) {
    CAPTURE(off);
    const auto material = rays.run({2 + off, 0, -6}, {0, 0, 1}, 30);
    CHECK(material.material);
    CHECK(material.ends);
    CHECK(material.length_mm == Approx(6).margin(kSame_mm));
    const auto air = rays.run({2 - off, 0, 3}, {0, 0, -1}, 30);
    CHECK_FALSE(air.material);
    CHECK(air.ends);
    CHECK(air.length_mm == Approx(8).margin(kSame_mm));
  }
  // Just beside a face of the raw stock.
  const auto face = rays.run({-9.9999, 0, -7}, {0, 0, 1}, 30);
  CHECK(face.length_mm == Approx(7).margin(kSame_mm));
  CHECK_FALSE(rays.run({0, 0, 5}, {0, 0, 1}, 4).ends);
  CHECK(rays.run({0, 0, 5}, {0, 0, 1}, 4).length_mm == 4);
}
