// A stock cut by a pass in the pass's own frame, and the turned stock cut by the pass as it lies
// there: the same material.
#include <algorithm>
#include <cmath>

#include "simulator/grid/stock_grid.h"
#include "simulator/stock/material.h"
#include "simulator/stock/stock_model.h"
#include "simulator/tolerance.h"
#include "tests/simulator/setups/turned_bench.h"
#include "tests/support/catch.h"
#include "tests/support/effort.h"

namespace {

using namespace limitgauge;
using model::Box3;
using model::Pose;
using model::Vec3;
using simulator::Pass;
using simulator::StockModel;
using namespace simulator::test;

constexpr double kTurnedVoxel = 0.4;

StockModel cut_in_own(const Pass& pass, double voxel = kTurnedVoxel) {
  return StockModel(setup_block(), voxel, kSetupBytes).cut(pass, {2});
}

StockModel cut_in_other(const Pass& pass, const Pose& pose, double voxel = kTurnedVoxel,
                        std::size_t bytes = kSetupBytes) {
  return StockModel(turned(setup_block(), pose), voxel, bytes).cut(placed(pass, pose), {2});
}

Vec3 nearest_voxel(const simulator::Lattice& lattice, const Vec3& p) {
  const Vec3 at = (p - lattice.origin_mm) / lattice.voxel_mm;
  return lattice.point({static_cast<int>(std::lround(at.x)), static_cast<int>(std::lround(at.y)),
                        static_cast<int>(std::lround(at.z))});
}

Box3 about_block() {
  const model::BoxStock block = setup_block();
  return Box3{block.corner_mm, block.corner_mm + block.size_mm}.grown(2);
}

}  // namespace

TEST_CASE("the exact material turns along with its frame", "[property][setups]") {
  for (const TurnedCase& t : many_turned_cases()) {
    INFO(t.to.name << ", " << model::to_text(t.cutter));
    const Pose& pose = t.to.pose;
    const Pass pass = moves_of_all_kinds(t.cutter, t.seed);
    const StockModel own = cut_in_own(pass, 1), other = cut_in_other(pass, pose, 1);
    PlaceDraw draw(about_block(), t.seed);
    double worst = 0;
    int turned_along = 0, removed = 0;
    constexpr int kPlaces = 4000;
    for (int i = 0; i < kPlaces; ++i) {
      const Vec3 p = draw(), q = pose.point(p);
      const auto here = own.material().sample(p), there = other.material().sample(q);
      worst = std::max(worst, std::abs(here.value - there.value));
      removed += here.maker.pass > 0;
      // Two of equal distance may change places, and a kink has many gradients.
      turned_along += distance(pose.direction(here.gradient), there.gradient) < 1e-6;
    }
    CHECK(worst < 1e-9);
    CHECK(removed > kPlaces / 6);
    CHECK(turned_along > 0.99 * kPlaces);
  }
}

TEST_CASE("the level set of a turned pass holds the exact distances", "[property][setups][slow]") {
  for (const TurnedCase& t : many_turned_cases()) {
    INFO(t.to.name << ", " << model::to_text(t.cutter));
    const StockModel stock = cut_in_other(moves_of_all_kinds(t.cutter, t.seed), t.to.pose);
    const simulator::Lattice& lattice = stock.grid().lattice();
    PlaceDraw draw(t.to.pose.box(about_block()), t.seed);
    double worst = 0;
    for (int i = 0; i < 8000; ++i) {
      const Vec3 p = nearest_voxel(lattice, draw());
      const double exact = std::clamp(stock.exact_value(p), -stock.band_mm(), stock.band_mm());
      worst = std::max(worst, std::abs(stock.value(p) - exact));
    }
    CHECK(worst < 2 * simulator::kSinglePrecision_voxels * lattice.voxel_mm);
  }
}

TEST_CASE("a half turn that rounding left an atom beside the axes cuts where it lies",
          "[unit][setups]") {
  // As the turns of two rotary axes multiply: the sum of a row is 1 to the last bit.
  constexpr double kAtom = 1.1102230246251565e-16;
  Pose pose;
  pose.rows = {Vec3{-1, -kAtom, kAtom / 4}, Vec3{kAtom, -1, 0}, Vec3{kAtom / 4, 0, 1}};
  pose.shift_mm = {3, -2, 5};
  REQUIRE(pose.keeps_axes());
  const StockModel stock = cut_in_other(moves_of_all_kinds(setup_cutters()[1], 7), pose, 1);
  const simulator::Lattice& lattice = stock.grid().lattice();
  PlaceDraw draw(pose.box(about_block()), 7);
  double worst = 0;
  for (int i = 0; i < 2000; ++i) {
    const Vec3 p = nearest_voxel(lattice, draw());
    const double exact = std::clamp(stock.exact_value(p), -stock.band_mm(), stock.band_mm());
    worst = std::max(worst, std::abs(stock.value(p) - exact));
  }
  CHECK(worst < 2 * simulator::kSinglePrecision_voxels * lattice.voxel_mm);
}

TEST_CASE("a turned stock has the volume of the stock", "[slow][setups]") {
  // Every third meets each cutter and each change of setup.
  const auto cases = turned_cases();
  for (std::size_t i = 0; i < cases.size(); i += tests::by_effort(3, 1)) {
    const TurnedCase& t = cases[i];
    INFO(t.to.name << ", " << model::to_text(t.cutter));
    const Pass pass = moves_of_all_kinds(t.cutter, t.seed + 40);
    const double own = cut_in_own(pass).volume_mm3({2});
    const double other = cut_in_other(pass, t.to.pose).volume_mm3({2});
    // Each is off by a few hundredths of surface times voxel, and the surface is about 2000 mm².
    CHECK(std::abs(own - other) < 0.01 * 2000 * kTurnedVoxel);
    CHECK(own < 0.9 * 24 * 18 * 8);
  }
}

TEST_CASE("points of a turned stock's surface lie on it, and its mesh on them",
          "[property][setups]") {
  const auto to = GENERATE(from_range(setup_poses()));
  const auto c = GENERATE(from_range(setup_cutters()));
  INFO(to.name << ", " << model::to_text(c));
  const Pass pass = moves_of_all_kinds(c, 61);
  const StockModel own = cut_in_own(pass), other = cut_in_other(pass, to.pose);
  const auto points = other.surface_points({2});
  REQUIRE(points.size() > 5000);
  double worst = 0;
  std::size_t astray = 0;
  for (const simulator::StockPoint& point : points) {
    const double phi = own.exact_value(to.pose.point_back(point.position));
    worst = std::max(worst, std::abs(std::abs(phi) - point.residual_mm));
    astray += point.residual_mm > 1e-9;
  }
  CHECK(worst < 1e-9);
  CHECK(astray < points.size() / 1000);
  const auto surface = other.surface({2});
  CHECK(surface.unmoved < surface.mesh.vertices.size() / 100);
  double off = 0;
  for (const Vec3& v : surface.mesh.vertices)
    off = std::max(off, std::abs(own.exact_value(to.pose.point_back(v))));
  CHECK(off < kTurnedVoxel);
}

TEST_CASE("rows of fine voxels are right in a turned block, whole leaves at once",
          "[property][setups][slow]") {
  const auto to = GENERATE(from_range(setup_poses()));
  INFO(to.name);
  // Small for the ball: its leaves are worked out in single precision where they are straight.
  constexpr double kFine = 0.08;
  const Pass rows = raster(
      cutter(model::CutterType::ball, 5, 9), 6, 0.7, 0.5,
      [](double x, double y) { return -3.0 + 0.6 * std::sin(0.7 * x) + 0.4 * std::cos(0.9 * y); });
  const StockModel own = cut_in_own(rows, kFine), other = cut_in_other(rows, to.pose, kFine);
  const simulator::Lattice lattice = other.grid().lattice();
  double worst = 0;
  const auto points = own.surface_points({2});
  for (std::size_t i = 0; i < points.size(); i += 7) {
    const Vec3 p = nearest_voxel(lattice, to.pose.point(points[i].position));
    worst = std::max(worst, std::abs(other.value(p) - own.exact_value(to.pose.point_back(p))));
  }
  CHECK(points.size() > 50000);
  CHECK(worst < 2 * simulator::kSinglePrecision_voxels * kFine);
}

TEST_CASE("a turned stock in tiles is the whole one", "[slow][setups]") {
  const std::size_t to = GENERATE(0, 2), cutter = GENERATE(1, 2);
  // Each pose and each cutter once; all pairs take two minutes.
  if (!tests::thorough() && (to == 0) != (cutter == 1)) return;
  const Pose pose = setup_poses()[to].pose;
  INFO(setup_poses()[to].name << ", " << model::to_text(setup_cutters()[cutter]));
  constexpr double kFine = 0.06;
  constexpr std::size_t kLittle = std::size_t{14} << 20;
  const Pass pass = moves_of_all_kinds(setup_cutters()[cutter], 71);
  const StockModel whole = cut_in_other(pass, pose, kFine);
  const StockModel tiled = cut_in_other(pass, pose, kFine, kLittle);
  REQUIRE(whole.tiles() == 0);
  REQUIRE(tiled.tiles() > 1);
  CHECK(tiled.volume_mm3() == whole.volume_mm3());
  CHECK(tiled.column_tops().top_mm == whole.column_tops().top_mm);
  const Box3 region = pose.box({{-6, -4, -5}, {3, 4, 1}});
  const auto a = whole.surface_points(region, {2}), b = tiled.surface_points(region, {2});
  REQUIRE(a.size() > 1000);
  REQUIRE(a.size() == b.size());
  CHECK(std::equal(a.begin(), a.end(), b.begin(),
                   [](const auto& p, const auto& q) { return p.position == q.position; }));
}

TEST_CASE("a forecast knows what a turned pass will take", "[property][setups]") {
  for (const NamedPose& to : setup_poses()) {
    INFO(to.name);
    const Pass pass = moves_of_all_kinds(setup_cutters()[1], 81);
    const StockModel raw(turned(setup_block(), to.pose), 0.15, kSetupBytes);
    const auto forecast = raw.forecast(placed(pass, to.pose), {2});
    const auto taken = static_cast<double>(raw.cut(placed(pass, to.pose), {2}).memory_bytes());
    CHECK(forecast.bytes > 0.6 * taken);
    CHECK(forecast.bytes < 1.8 * taken);
  }
}
