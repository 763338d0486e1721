#include "simulator/stock/stock_model.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <numbers>
#include <random>
#include <stdexcept>

#include "model/base/error.h"
#include "tests/simulator/paths.h"
#include "tests/support/catch.h"
#include "tests/support/temporary_folder.h"

namespace {

using namespace limitgauge;
using model::BoxStock;
using model::CutterType;
using model::RunControl;
using model::Vec3;
using simulator::Pass;
using simulator::StockModel;
using simulator::test::cutter;
using simulator::test::PathBuilder;
using simulator::test::raster;

constexpr std::size_t kPlenty = std::size_t{2} << 30;
constexpr double kPi = std::numbers::pi;

StockModel block(double voxel) {
  return {BoxStock{{-15, -10, -8}, {30, 20, 8}}, voxel, kPlenty};
}

double removed(const StockModel& before, const Pass& pass) {
  return before.volume_mm3() - before.cut(pass, {2}).volume_mm3();
}

double segment_area(double r, double d) {
  return r * r * std::acos((r - d) / r) - (r - d) * std::sqrt(2 * r * d - d * d);
}

// Gentle waves with sloped moves in every direction, for any cutter.
Pass waves(const model::Cutter& c) {
  return raster(c, 7, 1.3, 0.7, [](double x, double y) {
    return -2.0 + 0.6 * std::sin(0.7 * x) + 0.4 * std::cos(0.9 * y);
  });
}

std::array<model::Cutter, 4> cutters() {
  return {cutter(CutterType::flat, 4, 20), cutter(CutterType::ball, 5, 20),
          cutter(CutterType::bull, 5, 20, 1), cutter(CutterType::taper, 2, 20, 0.5, 12)};
}

std::string bytes_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::string vdb_bytes(const StockModel& stock) {
  const tests::TemporaryFolder folder;
  const auto file = folder.path() / "stock.vdb";
  stock.write_vdb(file);
  return bytes_of(file);
}

double largest_difference(const StockModel& a, const StockModel& b) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<> x(-15, 15), y(-10, 10), z(-8, 0.5);
  double worst = 0;
  for (int i = 0; i < 40000; ++i) {
    const Vec3 p{x(random), y(random), z(random)};
    worst = std::max(worst, std::abs(a.value(p) - b.value(p)));
  }
  return worst;
}

}  // namespace

TEST_CASE("a raw block on the lattice has its exact volume", "[unit][stock_model]") {
  // Single precision voxel values: 1e-7 of the band a face voxel.
  CHECK(block(0.25).volume_mm3() == Approx(4800).epsilon(1e-7));
  CHECK(block(0.25).value({0, 0, -0.1}) == Approx(-0.1).margin(1e-7));
  CHECK(block(0.25).exact_value({20, 0, 4}) == Approx(std::sqrt(41.0)).margin(1e-12));
}

TEST_CASE("a raw bar's volume is of second order in the voxel", "[unit][stock_model]") {
  const model::CylinderStock bar{{1, 2, 3}, 10, 7};
  const double exact = kPi * 25 * 7;
  const double coarse = StockModel(bar, 0.4, kPlenty).volume_mm3() - exact;
  const double fine = StockModel(bar, 0.1, kPlenty).volume_mm3() - exact;
  CHECK(std::abs(fine) < 1e-3 * exact);
  CHECK(std::abs(fine) < 0.25 * std::abs(coarse));
}

TEST_CASE("a ball slot removes the closed form's volume", "[unit][stock_model]") {
  const double r = 3, d = GENERATE(1.3, 3.0), length = 11.7;
  const Pass slot = PathBuilder({-6.2, 0.7, -d})
                        .feed({-6.2 + length, 0.7, -d})
                        .pass(cutter(CutterType::ball, 2 * r, 20));
  const double exact = segment_area(r, d) * length + kPi * d * d * (3 * r - d) / 3;
  // A tenth of a percent at R/30, the promise of the volume.
  CHECK(removed(block(r / 30), slot) == Approx(exact).epsilon(1e-3));
}

TEST_CASE("a flat slot removes the closed form's volume", "[unit][stock_model]") {
  const double r = 4, d = 2.37, length = 9.3;
  const Pass slot = PathBuilder({-5, 0.3, 10})
                        .rapid({-5, 0.3, 1})
                        .feed({-5, 0.3, -d})
                        .feed({-5 + length, 0.3, -d})
                        .rapid({-5 + length, 0.3, 10})
                        .pass(cutter(CutterType::flat, 2 * r, 20));
  const double exact = 2 * r * d * length + kPi * r * r * d;
  CHECK(removed(block(r / 30), slot) == Approx(exact).epsilon(1e-3));
}

TEST_CASE("a full circle removes the closed form's volume", "[unit][stock_model]") {
  const bool ball = GENERATE(true, false);
  const double r = 2, rho = 5, d = 1.6;
  const int chords = 720;
  PathBuilder b({rho, 0, -d});
  for (int i = 1; i <= chords; ++i)
    b.feed({rho * std::cos(2 * kPi * i / chords), rho * std::sin(2 * kPi * i / chords), -d});
  const auto c = cutter(ball ? CutterType::ball : CutterType::flat, 2 * r, 20);
  const double exact = ball ? 2 * kPi * rho * segment_area(r, d) : 4 * kPi * rho * r * d;
  // The chords' error is rho (π/720)²/2 of the width: 1e-5 of the volume.
  CHECK(removed(block(r / 30), b.pass(c)) == Approx(exact).epsilon(1e-3));
}

TEST_CASE("band voxels agree with the exact level set", "[property][stock_model]") {
  const double voxel = 0.3;
  for (const auto& c : cutters()) {
    const StockModel stock = block(voxel).cut(waves(c), {2});
    double worst = 0;
    int inside_band = 0;
    // Voxel centres are at the block's lower corner plus multiples of the voxel.
    for (int i = 0; i <= 100; ++i)
      for (int j = 0; j <= 66; ++j)
        for (int k = 0; k <= 28; ++k) {
          const Vec3 p = Vec3{-15, -10, -8} + Vec3{1.0 * i, 1.0 * j, 1.0 * k} * voxel;
          const double exact = std::clamp(stock.exact_value(p), -stock.band_mm(), stock.band_mm());
          inside_band += std::abs(exact) < stock.band_mm();
          worst = std::max(worst, std::abs(stock.value(p) - exact));
        }
    CHECK(inside_band > 10000);
    CHECK(worst <= 1e-6);  // single precision of a band of 0.9 mm, and the point's own rounding
  }
}

TEST_CASE("flutes end where they end: a short cutter leaves what is above it",
          "[unit][stock_model]") {
  const bool ball = GENERATE(true, false);
  const auto c = cutter(ball ? CutterType::ball : CutterType::flat, 4, 3);
  const Pass slot = PathBuilder({-20, 0, -6}).feed({20, 0, -6}).pass(c);
  const StockModel stock = block(0.2).cut(slot, {2});
  CHECK(stock.value({0, 0, -4.6}) == Approx(0.6).margin(1e-6));
  CHECK(stock.value({0, 0, -2.6}) == Approx(-0.4).margin(1e-6));
  CHECK(stock.exact_value({0, 0, -2}) == Approx(-1).margin(1e-12));
}

TEST_CASE("the stock is the same for any number of threads", "[property][stock_model]") {
  const Pass pass = waves(cutter(CutterType::bull, 5, 20, 1));
  const StockModel one = block(0.25).cut(pass, {1});
  const std::string bytes = vdb_bytes(one);
  REQUIRE(bytes.size() > 10000);
  for (const unsigned threads : {2u, 3u}) {
    const StockModel other = block(0.25).cut(pass, {threads});
    CHECK(bytes == vdb_bytes(other));
    CHECK(one.volume_mm3() == other.volume_mm3());
    const auto p = one.surface_points({1}), q = other.surface_points({threads});
    REQUIRE(p.size() == q.size());
    CHECK(std::equal(p.begin(), p.end(), q.begin(), [](const auto& a, const auto& b) {
      return a.position == b.position && a.residual_mm == b.residual_mm;
    }));
  }
}

TEST_CASE("the stock does not depend on the order of moves", "[property][stock_model]") {
  const auto c = cutter(CutterType::ball, 5, 20);
  const auto height = [](double x, double y) { return -1 - 0.05 * std::abs(x * y) / 4; };
  PathBuilder forward({0, 0, 0}), backward({0, 0, 0});
  std::vector<std::array<Vec3, 2>> rows;
  for (double y = -6; y <= 6; y += 0.8)
    rows.push_back({Vec3{-7, y, height(-7, y)}, Vec3{7, y, height(2, y)}});
  for (std::size_t i = 0; i < rows.size(); ++i) {
    // The links run along one line above the stock, so that both orders sweep the same space.
    const auto& f = rows[i];
    forward.rapid({0, 0, 40}).rapid({f[0].x, f[0].y, 40}).rapid(f[0]).feed(f[1]);
    forward.rapid({f[1].x, f[1].y, 40});
    const auto& b = rows[rows.size() - 1 - i];
    backward.rapid({0, 0, 40}).rapid({b[0].x, b[0].y, 40}).rapid(b[0]).feed(b[1]);
    backward.rapid({b[1].x, b[1].y, 40});
  }
  const StockModel a = block(0.25).cut(forward.pass(c), {2});
  const StockModel b = block(0.25).cut(backward.pass(c), {2});
  CHECK(a.volume_mm3() == b.volume_mm3());
  CHECK(largest_difference(a, b) == 0);
}

TEST_CASE("a split move cuts what the whole one cuts", "[property][stock_model]") {
  for (const auto& c : cutters()) {
    const Vec3 from{-9, -4, -1}, to{8, 5, -5};
    PathBuilder split(from);
    for (int i = 1; i <= 7; ++i) split.feed(lerp(from, to, i / 7.0));
    const StockModel a = block(0.25).cut(PathBuilder(from).feed(to).pass(c), {2});
    const StockModel b = block(0.25).cut(split.pass(c), {2});
    // Rounding of the split points and one last bit of single precision.
    CHECK(largest_difference(a, b) <= 2e-7);
  }
}

TEST_CASE("two passes cut what one pass of both paths cuts", "[property][stock_model]") {
  const auto c = cutter(CutterType::ball, 4, 20);
  const Pass first = PathBuilder({-9, 0, -2}).feed({9, 0, -3}).pass(c);
  const Pass second = PathBuilder({9, 0, -3}).feed({1, 8, -1}).pass(c);
  const Pass both = PathBuilder({-9, 0, -2}).feed({9, 0, -3}).feed({1, 8, -1}).pass(c);
  const StockModel a = block(0.2).cut(first, {2}).cut(second, {2});
  const StockModel b = block(0.2).cut(both, {2});
  CHECK(largest_difference(a, b) == 0);
  CHECK(a.exact_value({3, 3, -1}) == b.exact_value({3, 3, -1}));
}

TEST_CASE("the stock stands where an independent height map says", "[property][stock_model]") {
  const double voxel = 0.2, r = 2.5;
  const bool ball = GENERATE(true, false);
  const Pass pass = waves(cutter(ball ? CutterType::ball : CutterType::flat, 2 * r, 30));
  const StockModel stock = block(voxel).cut(pass, {2});
  // Height at (x, y): the lowest profile point over densely sampled tip positions.
  const auto height = [&](double x, double y) {
    double z = 0;
    for (std::size_t m = 0; m < pass.path->moves.size(); ++m)
      for (int k = 0; k <= 200; ++k) {
        const Vec3 tip = lerp(move_from(*pass.path, m), pass.path->moves[m].to, k / 200.0);
        const double rho2 = (x - tip.x) * (x - tip.x) + (y - tip.y) * (y - tip.y);
        if (rho2 <= r * r) z = std::min(z, tip.z + (ball ? r - std::sqrt(r * r - rho2) : 0.0));
      }
    return z;
  };
  std::mt19937_64 random(11);
  std::uniform_real_distribution<> in(-6, 6);
  for (int i = 0; i < 60; ++i) {
    const double x = in(random), y = in(random), h = height(x, y);
    // The sampling of 0.0035 mm a step moves a 45 degree wall by half of that; the stock's own
    // surface is exact.
    CHECK(stock.exact_value({x, y, h - 0.01}) < 0);
    CHECK(stock.exact_value({x, y, h + 0.01}) > 0);
  }
}

TEST_CASE("surface points lie on the exact surface", "[property][stock_model]") {
  for (const auto& c : cutters()) {
    const StockModel stock = block(0.25).cut(waves(c), {2});
    const auto points = stock.surface_points({2});
    double worst = 0;
    std::size_t bottom = 0;
    for (const auto& p : points) {
      worst = std::max(worst, std::abs(stock.exact_value(p.position)));
      REQUIRE(std::abs(stock.exact_value(p.position)) <= p.residual_mm + 1e-12);
      bottom += std::abs(p.position.z + 8) < 1e-6;
    }
    CHECK(worst <= 1e-6);
    // About one a voxel face: 30×20 mm of bottom at 0.25 mm.
    CHECK(bottom > 8640);
    CHECK(bottom < 10560);
  }
}

TEST_CASE("the surface mesh is closed, manifold and turned outwards", "[property][stock_model]") {
  for (const auto& c : cutters()) {
    const StockModel stock = block(0.3).cut(waves(c), {2});
    const auto mesh = stock.surface_mesh();
    std::map<std::array<std::uint32_t, 2>, int> forward;
    double volume = 0;
    for (const auto& t : mesh.triangles) {
      for (int k = 0; k < 3; ++k) ++forward[{t[k], t[(k + 1) % 3]}];
      volume += dot(mesh.vertices[t[0]], cross(mesh.vertices[t[1]], mesh.vertices[t[2]])) / 6;
    }
    std::size_t bad = 0;
    for (const auto& [edge, count] : forward)
      bad += count != 1 || !forward.count({edge[1], edge[0]});
    CHECK(bad == 0);
    // The mesh's one vertex a cell rounds sharp edges off: less than half a voxel squared along
    // the block's 232 mm and about as much again of the cut's rims.
    CHECK(volume == Approx(stock.volume_mm3()).margin(0.5 * 0.3 * 0.3 * 464));
  }
}

TEST_CASE("a pass over everything leaves nothing", "[unit][stock_model]") {
  const auto c = cutter(CutterType::flat, 60, 40);
  const StockModel stock =
      block(0.5).cut(PathBuilder({-50, 0, -20}).feed({50, 0, -20}).pass(c), {2});
  CHECK(stock.volume_mm3() == 0);
  CHECK(stock.surface_points({1}).empty());
  CHECK(stock.surface_mesh().triangles.empty());
}

TEST_CASE("an empty pass and a pass beside the stock change nothing", "[unit][stock_model]") {
  const auto c = cutter(CutterType::ball, 4, 20);
  const StockModel raw = block(0.5);
  CHECK(raw.cut(PathBuilder({0, 0, 0}).pass(c), {2}).volume_mm3() == raw.volume_mm3());
  CHECK(raw.cut(PathBuilder({50, 0, 0}).feed({60, 0, 0}).pass(c), {2}).volume_mm3() ==
        raw.volume_mm3());
}

TEST_CASE("a move of no length cuts, and so does a plunge", "[unit][stock_model]") {
  const auto c = cutter(CutterType::ball, 4, 20);
  const StockModel dot = block(0.25).cut(PathBuilder({0, 0, -1}).feed({0, 0, -1}).pass(c), {1});
  CHECK(dot.exact_value({0, 0, -1.5}) == Approx(-0.5).margin(1e-12));
  CHECK(dot.exact_value({0, 0, -0.5}) == Approx(0.5).margin(1e-12));
  const StockModel hole = block(0.25).cut(PathBuilder({0, 0, 5}).feed({0, 0, -3}).pass(c), {1});
  CHECK(hole.exact_value({0, 0, -3.25}) == Approx(-0.25).margin(1e-12));
  CHECK(hole.value({0, 0, -2.5}) == Approx(0.5).margin(1e-3));
}

TEST_CASE("what cannot be is refused", "[unit][stock_model]") {
  CHECK_THROWS_AS(block(0), std::invalid_argument);
  CHECK_THROWS_AS(block(-1), std::invalid_argument);
  CHECK_THROWS_AS(block(std::nan("")), std::invalid_argument);
  // Four MiB hold no tree with a column's tile beside it.
  std::string reason;
  try {
    StockModel(BoxStock{{0, 0, 0}, {40, 30, 10}}, 0.1, 4 << 20);
  } catch (const model::ResourceError& error) {
    reason = error.what();
  }
  CHECK_THAT(reason, ContainsSubstring("a voxel of "));
  CHECK_THROWS_AS(block(0.5).write_vdb("/nonexistent-folder/stock.vdb"), model::ResourceError);
  const auto c = cutter(CutterType::ball, 4, 20);
  CHECK_THROWS_AS(block(0.5).cut({c, nullptr}, {1}), std::invalid_argument);
  const Pass bad = PathBuilder({0, 0, 0}).feed({0, 0, std::nan("")}).pass(c);
  CHECK_THROWS_AS(block(0.5).cut(bad, {1}), std::invalid_argument);
}

TEST_CASE("voxels too fine to be counted are refused", "[slow][stock_model]") {
  CHECK_THROWS_AS(StockModel(BoxStock{{0, 0, 0}, {90, 80, 30}}, 1e-9, 64 << 20),
                  model::ResourceError);
}

TEST_CASE("cutting stops when asked to", "[unit][stock_model]") {
  const std::atomic<bool> stop = true;
  RunControl control{2};
  control.stop = &stop;
  CHECK_THROWS_AS(block(0.5).cut(waves(cutter(CutterType::ball, 4, 20)), control),
                  model::Interrupted);
}
