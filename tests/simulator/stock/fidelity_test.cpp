#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <numbers>
#include <random>

#include "simulator/stock/stock_model.h"
#include "tests/simulator/paths.h"
#include "tests/support/catch.h"
#include "tests/support/temporary_folder.h"

namespace {

using namespace limitgauge;
using model::BoxStock;
using model::CutterType;
using model::Vec3;
using simulator::Pass;
using simulator::StockModel;
using simulator::StockPoint;
using simulator::test::cutter;
using simulator::test::PathBuilder;
using simulator::test::raster;

constexpr std::size_t kFidelityBytes = std::size_t{2} << 30;
constexpr double kHalfTurn = std::numbers::pi;

StockModel fidelity_block(double voxel) {
  return {BoxStock{{-15, -10, -8}, {30, 20, 8}}, voxel, kFidelityBytes, {2}};
}

double removed(double voxel, const Pass& pass) {
  StockModel stock = fidelity_block(voxel);
  const double before = stock.volume_mm3({2});
  return before - std::move(stock).cut(pass, {2}).volume_mm3({2});
}

// Volume under z = 0 of a body whose underside is at `height`, over [−15, 15] × [−10, 10], by the
// midpoint rule: off by far less than 1e-4 of itself at 0.01 mm.
double volume_above(const std::function<double(double, double)>& height) {
  constexpr int kNx = 3000, kNy = 2000;
  double sum = 0;
  for (int i = 0; i < kNx; ++i)
    for (int j = 0; j < kNy; ++j)
      sum += std::max(0.0, -height(-15 + (i + 0.5) * 0.01, -10 + (j + 0.5) * 0.01));
  return sum * 1e-4;
}

std::string bytes_as_vdb(const StockModel& stock) {
  const tests::TemporaryFolder folder;
  const auto file = folder.path() / "stock.vdb";
  stock.write_vdb(file);
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

double worst_off(const StockModel& stock, const std::vector<StockPoint>& points) {
  double worst = 0;
  for (const StockPoint& p : points)
    worst = std::max(worst, std::abs(stock.exact_value(p.position)));
  return worst;
}

// Distinct moves whose links all run in the air, in some order.
struct Stroke {
  Vec3 from, to;
};
Pass strokes(const model::Cutter& c, const std::vector<Stroke>& in_order) {
  PathBuilder path({0, 0, 40});
  for (const Stroke& s : in_order) {
    path.rapid({s.from.x, s.from.y, 40}).feed(s.from).feed(s.to).rapid({s.to.x, s.to.y, 40});
    path.rapid({0, 0, 40});
  }
  return path.pass(c);
}

std::vector<Stroke> random_strokes(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<> x(-12, 12), y(-8, 8), z(-6, -0.5);
  std::vector<Stroke> all;
  for (int i = 0; i < 25; ++i)
    all.push_back({{x(random), y(random), z(random)}, {x(random), y(random), z(random)}});
  return all;
}

const std::vector<model::Cutter>& tried_cutters() {
  static const std::vector<model::Cutter> all{
      cutter(CutterType::flat, 4, 20), cutter(CutterType::ball, 5, 20),
      cutter(CutterType::bull, 5, 20, 1), cutter(CutterType::taper, 2, 20, 0.5, 12)};
  return all;
}

}  // namespace

TEST_CASE("a plunge removes the closed form's volume", "[unit][fidelity]") {
  const double r = 3, d = GENERATE(1.7, 4.3);
  const auto plunge = [&](CutterType type) {
    return PathBuilder({0.31, -0.17, 5}).feed({0.31, -0.17, -d}).pass(cutter(type, 2 * r, 20));
  };
  CHECK(removed(r / 30, plunge(CutterType::flat)) == Approx(kHalfTurn * r * r * d).epsilon(1e-3));
  const double nose = d < r ? kHalfTurn * d * d * (3 * r - d) / 3
                            : 2 * kHalfTurn * r * r * r / 3 + kHalfTurn * r * r * (d - r);
  CHECK(removed(r / 30, plunge(CutterType::ball)) == Approx(nose).epsilon(1e-3));
}

TEST_CASE("a pocket removes the closed form's volume", "[unit][fidelity]") {
  const double r = 2, d = 2.3, length = 9.1, width = 6.3;
  const Vec3 low{-5.03, -3.07, -d};
  PathBuilder path(low);
  path.feed(low + Vec3{length, 0, 0}).feed(low + Vec3{length, width, 0});
  path.feed(low + Vec3{0, width, 0}).feed(low);
  for (double y = 1.5; y < width; y += 1.5)
    path.feed(low + Vec3{0, y, 0}).feed(low + Vec3{length, y, 0}).feed(low + Vec3{0, y, 0});
  const double area = length * width + 2 * r * (length + width) + kHalfTurn * r * r;
  const auto pocket = path.pass(cutter(CutterType::flat, 2 * r, 20));
  CHECK(removed(r / 30, pocket) == Approx(area * d).epsilon(1e-3));
}

TEST_CASE("a ramp of a flat removes the closed form's volume", "[unit][fidelity]") {
  const double r = 3, d = 2.9, length = 11.3;
  const Pass ramp = PathBuilder({-5.6, 0.21, 0})
                        .feed({-5.6 + length, 0.21, -d})
                        .pass(cutter(CutterType::flat, 2 * r, 20));
  // At y from the middle, with c = √(r² − y²): the depth rises over the length and stays for 2c.
  const double exact = d * length * r + kHalfTurn * r * r * d;
  // The floor is made by the disc's trailing rim. The depth in the cutter falls from there by
  // 1 / (1 + tan 14°) a millimetre, not by cos 14°: a kink all along the floor, which would put the
  // crossing between two voxels off by 0.03 of a voxel, 0.2 % of the volume.
  CHECK(removed(r / 30, ramp) == Approx(exact).epsilon(1e-3));
}

TEST_CASE("a ramp of a ball removes the volume of its closed height", "[unit][fidelity]") {
  const double r = 3, d = 2.1, length = 10.7, x0 = -5.2;
  const Pass ramp =
      PathBuilder({x0, 0, 0}).feed({x0 + length, 0, -d}).pass(cutter(CutterType::ball, 2 * r, 20));
  const double along = std::hypot(length, d), ux = length / along, uz = -d / along;
  const double exact = volume_above([&](double x, double y) {
    if (std::abs(y) >= r) return 1.0;
    const double rho = std::sqrt(r * r - y * y);
    // The lower side of a stadium in the plane of this y: a line between two arcs.
    const auto arc = [&](double cx, double cz) {
      const double q = rho * rho - (x - cx) * (x - cx);
      return q > 0 ? cz - std::sqrt(q) : 1.0;
    };
    const double from = x0 + rho * uz, to = x0 + length + rho * uz;  // feet of the line's ends
    const double line = x >= from && x <= to ? r + (x - from) * uz / ux - rho * ux : 1.0;
    return std::min({arc(x0, r), arc(x0 + length, r - d), line});
  });
  CHECK(removed(r / 30, ramp) == Approx(exact).epsilon(1e-3));
}

TEST_CASE("points lie on the closed envelope of a ball's rows, cusps included",
          "[property][fidelity]") {
  const double voxel = 0.1, r = 3, step = 0.5, depth = 1.3;
  const Pass rows = raster(cutter(CutterType::ball, 2 * r, 20), 5, step, 10,
                           [&](double, double) { return -depth; });
  const StockModel stock = fidelity_block(voxel).cut(rows, {2});
  const auto envelope = [&](double y) {
    const double row = std::round((y + 5) / step) * step - 5;
    return r - depth - std::sqrt(r * r - (y - row) * (y - row));
  };
  const double cusp = envelope(-5 + step / 2) + depth;  // 0.0104 mm
  double worst = 0, highest = -depth;
  std::size_t count = 0;
  for (const StockPoint& p : stock.surface_points({{-4, -4, -2}, {4, 4, -1}}, {2})) {
    worst = std::max(worst, std::abs(p.position.z - envelope(p.position.y)));
    highest = std::max(highest, p.position.z);
    ++count;
  }
  CHECK(count > 5000);
  CHECK(worst < 1e-9);  // promised: 1e-4
  // Points are a voxel apart, a fifth of the step: some come within a tenth of it of the cusp.
  CHECK(highest + depth > 0.6 * cusp);
}

TEST_CASE("points lie on the closed envelope of crossing slots", "[property][fidelity]") {
  const double r = 2.5;
  const auto ball = cutter(CutterType::ball, 2 * r, 20);
  const Pass cross = PathBuilder({-9, 0, -2.2})
                         .feed({9, 0, -2.2})
                         .rapid({9, 0, 9})
                         .rapid({0.4, -9, 9})
                         .feed({0.4, -9, -1.7})
                         .feed({0.4, 9, -1.7})
                         .pass(ball);
  const StockModel stock = fidelity_block(0.1).cut(cross, {2});
  const auto slot = [&](double off, double tip) {
    return std::abs(off) < r ? tip + r - std::sqrt(r * r - off * off) : 1.0;
  };
  double worst = 0;
  std::size_t count = 0;
  for (const StockPoint& p : stock.surface_points({{-6, -6, -7}, {6, 6, 1}}, {2})) {
    if (p.position.z > -1e-6) continue;  // the raw top
    const double h = std::min({slot(p.position.y, -2.2), slot(p.position.x - 0.4, -1.7), 0.0});
    // Walls are nearly upright at the rim: the distance across, not the height, is what counts.
    const double across = std::abs(p.position.z - h);
    const double depth = std::abs(stock.exact_value(p.position));
    worst = std::max(worst, std::min(across, depth));
    if (p.position.z < -0.5) worst = std::max(worst, across);
    ++count;
  }
  CHECK(count > 5000);
  CHECK(worst < 1e-8);  // promised: 1e-4
}

TEST_CASE("the order of moves changes no bit of the stock", "[slow][fidelity]") {
  for (const auto& c : tried_cutters()) {
    std::vector<Stroke> all = random_strokes(3);
    const StockModel a = fidelity_block(0.2).cut(strokes(c, all), {2});
    std::mt19937_64 random(9);
    for (int i = 0; i < 2; ++i) {
      std::shuffle(all.begin(), all.end(), random);
      const StockModel b = fidelity_block(0.2).cut(strokes(c, all), {3});
      CHECK(bytes_as_vdb(a) == bytes_as_vdb(b));
      CHECK(a.volume_mm3() == b.volume_mm3());
      const auto p = a.surface_points({2}), q = b.surface_points({1});
      REQUIRE(p.size() == q.size());
      // Where two moves are equally near, a point may be led along the one or the other: both
      // places are on the surface.
      CHECK(worst_off(a, q) <= 1e-8);
      CHECK(worst_off(b, p) <= 1e-8);
    }
  }
}

TEST_CASE("moves cut in collinear pieces leave the same stock", "[slow][fidelity]") {
  for (const auto& c : tried_cutters()) {
    const std::vector<Stroke> whole = random_strokes(8);
    std::vector<Stroke> pieces;
    for (const Stroke& s : whole)
      for (int k = 0; k < 3; ++k)
        pieces.push_back({lerp(s.from, s.to, k / 3.0), lerp(s.from, s.to, (k + 1) / 3.0)});
    const StockModel a = fidelity_block(0.2).cut(strokes(c, whole), {2});
    // The pieces' ends are plunged to: along a slope that is no new space for a convex cutter only
    // within the flutes, so the pieces follow each other instead.
    PathBuilder path({0, 0, 40});
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      if (i % 3 == 0) path.rapid({pieces[i].from.x, pieces[i].from.y, 40}).feed(pieces[i].from);
      path.feed(pieces[i].to);
      if (i % 3 == 2) path.rapid({pieces[i].to.x, pieces[i].to.y, 40}).rapid({0, 0, 40});
    }
    const StockModel b = fidelity_block(0.2).cut(path.pass(c), {2});
    // The ends of the pieces are rounded to 2e-15 mm and the sloped moves' minimum is found to
    // 1e-10 mm: single precision of 0.6 mm may then fall on the next number, 6e-8 mm away.
    CHECK(a.volume_mm3() == Approx(b.volume_mm3()).epsilon(1e-8));
    const auto q = b.surface_points({2});
    CHECK(worst_off(a, q) <= 1e-8);
    const auto p = a.surface_points({2});
    // A voxel whose value is within that of zero may change sides.
    CHECK(std::abs(static_cast<double>(p.size()) - static_cast<double>(q.size())) <=
          1e-4 * static_cast<double>(p.size()));
  }
}
