#include <algorithm>
#include <cmath>
#include <string>

#include "model/base/error.h"
#include "simulator/grid/stock_grid.h"
#include "simulator/stock/stock_model.h"
#include "simulator/sweep/move_batch.h"
#include "tests/simulator/paths.h"
#include "tests/support/catch.h"

namespace {

using namespace limitgauge;
using model::BoxStock;
using model::CutterType;
using simulator::CutForecast;
using simulator::StockModel;
using simulator::test::cutter;
using simulator::test::PathBuilder;
using simulator::test::raster;

constexpr std::size_t kForecastBytes = std::size_t{4} << 30;

simulator::Pass rows(double half) {
  return raster(cutter(CutterType::ball, 5, 20), half, 0.9, 0.6, [](double x, double y) {
    return -3.0 + 0.8 * std::sin(0.5 * x) + 0.6 * std::cos(0.7 * y);
  });
}

double ratio_of_bytes(const StockModel& raw, const simulator::Pass& pass) {
  const CutForecast forecast = raw.forecast(pass, {2});
  CHECK(!forecast.tiled);
  CHECK(forecast.seconds > 0);
  CHECK(forecast.blocks > 0);
  return forecast.bytes / static_cast<double>(raw.cut(pass, {2}).memory_bytes());
}

}  // namespace

TEST_CASE("the forecast memory is the real one within a fifth", "[property][forecast]") {
  const model::CylinderStock bar{{1, 2, -12}, 26, 12};
  const BoxStock block{{-15, -12, -9}, {30, 24, 9}},
      odd{{-14.03, -11.07, -8.05}, {28.3, 22.9, 8.2}};
  for (const double voxel : {0.4, 0.2, 0.1}) {
    for (const model::Stock& stock : {model::Stock(block), model::Stock(odd), model::Stock(bar)}) {
      const StockModel raw(stock, voxel, kForecastBytes);
      // A few hundred blocks are measured out of some thousand; the promise is 30 %.
      CHECK(ratio_of_bytes(raw, rows(8)) == Approx(1).epsilon(0.2));
      CHECK(ratio_of_bytes(
                raw,
                PathBuilder({-9, 0, -2}).feed({9, 0, -3}).pass(cutter(CutterType::flat, 4, 20))) ==
            Approx(1).epsilon(0.2));
    }
  }
}

TEST_CASE("the forecast of a pass that swallows the stock is next to nothing", "[unit][forecast]") {
  const StockModel raw(BoxStock{{-15, -12, -9}, {30, 24, 9}}, 0.2, kForecastBytes);
  const simulator::Pass all =
      PathBuilder({-50, 0, -20}).feed({50, 0, -20}).pass(cutter(CutterType::flat, 60, 40));
  const CutForecast forecast = raw.forecast(all, {2});
  CHECK(forecast.blocks == 0);
  CHECK(forecast.bytes < 0.1 * static_cast<double>(raw.memory_bytes()));
}

TEST_CASE("a stock that would not fit is forecast and cut in tiles", "[property][forecast]") {
  const BoxStock block{{-15, -12, -9}, {30, 24, 9}};
  const double voxel = 0.1;
  // Slots a millimetre apart more than double the surface.
  const simulator::Pass pass =
      raster(cutter(CutterType::flat, 1, 20), 11, 2, 22, [](double, double) { return -7.0; });
  const StockModel plenty(block, voxel, kForecastBytes);
  const std::size_t whole = plenty.cut(pass, {2}).memory_bytes();
  const std::size_t limit = (plenty.memory_bytes() + whole) / 2;
  REQUIRE(static_cast<double>(limit) > 1.2 * static_cast<double>(plenty.memory_bytes()));
  StockModel raw(block, voxel, limit);
  REQUIRE(raw.tiles() == 0);
  const CutForecast forecast = raw.forecast(pass, {2});
  CHECK(forecast.bytes <= static_cast<double>(limit));
  CHECK(forecast.tiled);
  const StockModel cut = std::move(raw).cut(pass, {2});
  CHECK(cut.tiles() > 0);
  CHECK(cut.memory_bytes() <= limit);
}

TEST_CASE("a voxel that is said to do does", "[slow][forecast]") {
  const model::Stock box = BoxStock{{0, 0, 0}, {90, 80, 30}};
  for (const std::size_t mib : {3, 4, 5}) {
    const std::size_t limit = mib << 20;
    std::string text;
    try {
      StockModel(box, 0.1, limit);
    } catch (const model::ResourceError& e) {
      text = e.what();
    }
    INFO(text);
    const std::string mark = "; a voxel of ";
    REQUIRE(text.find(mark) != std::string::npos);
    const double voxel = std::stod(text.substr(text.find(mark) + mark.size()));
    CHECK(voxel > 0.1);
    const StockModel fits(box, voxel, limit);
    CHECK(fits.memory_bytes() <= limit);
  }
}

TEST_CASE("moves that alone are too many are refused", "[unit][forecast]") {
  const StockModel raw(BoxStock{{-15, -12, -9}, {30, 24, 9}}, 1.0, 4 << 20);
  PathBuilder path({0, 0, 0});
  for (int i = 0; i < 50000; ++i) path.feed({0.001 * i, 0, 0});
  CHECK_THROWS_WITH(raw.cut(path.pass(cutter(CutterType::ball, 4, 20)), {2}),
                    ContainsSubstring("the moves alone need"));
}

TEST_CASE("more moves on a small place than are handed down are cut as exactly",
          "[property][forecast]") {
  // 90,000 moves within four millimetres: all of them matter in each block of 8 mm.
  const simulator::Pass dense =
      raster(cutter(CutterType::ball, 5, 20), 2, 4.0 / 300, 4.0 / 300,
             [](double x, double y) { return -2.0 + 0.05 * (x * x + y * y); });
  REQUIRE(dense.path->moves.size() > simulator::kMostHandedDown);
  const StockModel raw(BoxStock{{-8, -8, -8}, {16, 16, 8}}, 0.25, kForecastBytes);
  const StockModel cut = raw.cut(dense, {2});
  const auto points = cut.surface_points({2});
  CHECK(points.size() > 10000);
  for (const auto& point : points) REQUIRE(std::abs(cut.exact_value(point.position)) < 1e-4);
  for (int i = 0; i < 500; ++i) {
    // Voxel centres: nothing is interpolated.
    const model::Vec3 p{-8 + 0.25 * (i % 60), -8 + 0.25 * (7 * i % 60), -8 + 0.25 * (11 * i % 32)};
    const double exact = std::clamp(cut.exact_value(p), -cut.band_mm(), cut.band_mm());
    REQUIRE(cut.value(p) == Approx(exact).margin(1e-6));
  }
}
