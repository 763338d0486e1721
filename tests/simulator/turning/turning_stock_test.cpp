// Stock that is cut by a tool that turns as it goes.
#include <algorithm>
#include <cmath>

#include "simulator/grid/stock_grid.h"
#include "simulator/instrument/stock_rays.h"
#include "simulator/stock/material.h"
#include "simulator/stock/stock_model.h"
#include "simulator/tolerance.h"
#include "tests/simulator/paths.h"
#include "tests/simulator/turning/turning_bench.h"
#include "tests/support/catch.h"
#include "tests/support/effort.h"

namespace {

using namespace limitgauge;
using model::Box3;
using model::Pass;
using model::Vec3;
using simulator::StockModel;
using namespace simulator::test;

constexpr std::size_t kTurningBytes = std::size_t{1} << 30;
constexpr double kTurningVoxel = 0.4;

StockModel turning_stock(const Pass& pass, unsigned threads = 2, double voxel = kTurningVoxel) {
  return StockModel(turning_block(), voxel, kTurningBytes).cut(pass, {threads});
}

double brute_phi(const Pass& pass, const Vec3& p) {
  const ProfileOracle oracle(pass.cutter);
  const model::BoxStock block = turning_block();
  const Vec3 low = block.corner_mm, high = low + block.size_mm;
  double swept = std::numeric_limits<double>::infinity();
  for (const TurnedMove& m : turned_moves(pass))
    swept = std::min(swept, brute_turning_distance(oracle, m, p, 40));
  const Vec3 over{std::max(low.x - p.x, p.x - high.x), std::max(low.y - p.y, p.y - high.y),
                  std::max(low.z - p.z, p.z - high.z)};
  const double in = std::max({over.x, over.y, over.z});
  const Vec3 out{std::max(0.0, over.x), std::max(0.0, over.y), std::max(0.0, over.z)};
  return std::max(in > 0 ? length(out) : in, -swept);
}

/// Every voxel of the band holds the exact value.
double worst_voxel(const StockModel& stock) {
  double worst = 0;
  const simulator::GridLeaves leaves(stock.grid());
  for (std::size_t leaf = 0; leaf < leaves.size(); leaf += 3)
    for (const simulator::Index3& at : leaves.surface_voxels(leaf)) {
      const Vec3 p = stock.grid().lattice().point(at);
      worst = std::max(worst, std::abs(stock.value(p) - stock.exact_value(p)));
    }
  return worst;
}

Pass reordered(const Pass& pass) {
  std::vector<TurnedMove> chain;
  std::vector<TurnedMove> moves = turned_moves(pass);
  std::reverse(moves.begin(), moves.end());
  for (const TurnedMove& m : moves) chain.push_back({m.to, m.from, m.axis_to, m.axis_from});
  return with_axes(pass.cutter, chain);
}

Pass halved(const Pass& pass) {
  std::vector<TurnedMove> chain;
  for (const TurnedMove& m : turned_moves(pass)) {
    const Vec3 middle = (m.from + m.to) * 0.5;
    chain.push_back({m.from, middle, m.axis_from, m.axis(0.5)});
    chain.push_back({middle, m.to, m.axis(0.5), m.axis_to});
  }
  return with_axes(pass.cutter, chain);
}

}  // namespace

TEST_CASE("the material left by turning moves is that of many poses", "[property][turning]") {
  for (unsigned seed = 0; seed < turning_cutters().size(); ++seed) {
    const Pass pass = turning_pass(turning_cutters()[seed], seed, 20);
    const StockModel stock = turning_stock(pass, 2, 1);
    TurningDraw draw(seed);
    INFO(model::to_text(pass.cutter));
    for (int n = 0; n < 60; ++n) {
      const Vec3 p{draw.between(-13, 13), draw.between(-10, 10), draw.between(-10, 1)};
      CHECK(stock.exact_value(p) == Approx(brute_phi(pass, p)).margin(3e-9));
    }
  }
}

TEST_CASE("the level set of turning moves holds the exact distances", "[slow][turning]") {
  for (unsigned seed = 0; seed < turning_cutters().size(); ++seed) {
    const StockModel stock = turning_stock(turning_pass(turning_cutters()[seed], seed));
    INFO(model::to_text(turning_cutters()[seed]));
    CHECK(worst_voxel(stock) < 2e-6);
    for (const simulator::StockPoint& p : stock.surface_points({2}))
      if (p.residual_mm > 1e-9) FAIL("a point is " << p.residual_mm << " mm off the surface");
  }
}

TEST_CASE("turning moves cut the same on any number of threads", "[property][turning]") {
  for (unsigned seed = 0; seed < 3; ++seed) {
    const Pass pass = turning_pass(turning_cutters()[seed], seed, 12);
    const StockModel one = turning_stock(pass, 1), two = turning_stock(pass, 2);
    CHECK(one.grid().changed_voxels(two.grid()).empty());
    CHECK(one.volume_mm3({1}) == two.volume_mm3({2}));
  }
}

TEST_CASE("the order of turning moves and where they are cut in two do not matter",
          "[slow][turning]") {
  for (unsigned seed = 0; seed < 4; ++seed) {
    const Pass pass = turning_pass(turning_cutters()[seed], seed, 20);
    const StockModel stock = turning_stock(pass), back = turning_stock(reordered(pass)),
                     fine = turning_stock(halved(pass));
    TurningDraw draw(seed);
    for (int n = 0; n < 400; ++n) {
      const Vec3 p{draw.between(-13, 13), draw.between(-10, 10), draw.between(-10, 1)};
      CHECK(back.exact_value(p) == Approx(stock.exact_value(p)).margin(1e-9));
      CHECK(fine.exact_value(p) == Approx(stock.exact_value(p)).margin(1e-9));
      CHECK(fine.value(p) == Approx(stock.value(p)).margin(2e-6));
    }
    // Which cells are bent may change with a millionth of a voxel, and with it their sample.
    CHECK(fine.volume_mm3() == Approx(stock.volume_mm3()).epsilon(1e-4));
  }
}

TEST_CASE("axes that stay along +Z cut as no axes do, and leaning ones as a turned pass",
          "[property][turning]") {
  for (unsigned seed = 0; seed < 4; ++seed) {
    const model::Cutter& cutter = turning_cutters()[seed];
    const Pass turning = turning_pass(cutter, seed);
    const Pass upright{cutter, turning.path};
    const model::Pose lean = model::turn_about({1, 1, 0}, 25);
    const Pass turned{
        cutter,
        std::make_shared<const model::Toolpath>(model::turned(*turning.path, lean.inverse())),
        lean};
    for (const Pass& plain : {upright, turned}) {
      Pass with{cutter, turning.path};
      model::ToolAxes axes;
      axes.start = plain.pose.direction({0, 0, 1});
      axes.to.assign(turning.path->moves.size(), axes.start);
      with.axes = std::make_shared<const model::ToolAxes>(axes);
      const StockModel a = turning_stock(plain), b = turning_stock(with);
      TurningDraw draw(seed);
      for (int n = 0; n < 500; ++n) {
        const Vec3 p{draw.between(-13, 13), draw.between(-10, 10), draw.between(-10, 1)};
        CHECK(b.exact_value(p) == Approx(a.exact_value(p)).margin(1e-9));
        CHECK(b.value(p) == Approx(a.value(p)).margin(3e-6));
      }
    }
  }
}

TEST_CASE("upright and turning passes cut one after the other, in any frame",
          "[property][turning]") {
  const Pass turning = turning_pass(turning_cutters()[1], 11);
  const Pass upright =
      PathBuilder({-14, 0, 5}).feed({-14, 0, -4}).feed({14, 3, -3}).pass(turning_cutters()[0]);
  const auto raw = [] { return StockModel(turning_block(), kTurningVoxel, kTurningBytes); };
  const StockModel a = raw().cut(turning, {2}).cut(upright, {2}),
                   b = raw().cut(upright, {2}).cut(turning, {2});
  Pass elsewhere = turning;
  elsewhere.pose = model::turn_about({0, 1, 1}, 20);
  const StockModel c = raw().cut(elsewhere, {2}).cut(upright, {2});
  const simulator::SweepIndex own(turning);
  CHECK(worst_voxel(a) < 2e-6);
  TurningDraw draw(11);
  for (int n = 0; n < 500; ++n) {
    const Vec3 p{draw.between(-13, 13), draw.between(-10, 10), draw.between(-10, 1)};
    CHECK(a.exact_value(p) == b.exact_value(p));
    const auto there = own.nearest(elsewhere.pose.point_back(p), 1e9);
    CHECK(c.exact_value(p) >= -there->at.distance - 1e-9);
    CHECK(std::abs(c.value(p) - std::clamp(c.exact_value(p), -c.band_mm(), c.band_mm())) <
          kTurningVoxel);
  }
  CHECK(worst_voxel(c) < 2e-6);
}

TEST_CASE("an axis that is wrong is seen in the stock", "[unit][turning]") {
  const Pass pass = turning_pass(turning_cutters()[1], 5);
  const StockModel right = turning_stock(pass);
  model::ToolAxes axes = *pass.axes;
  axes.to[12] = model::normalized(axes.to[12] + Vec3{0.01, 0, 0});
  Pass other = pass;
  other.axes = std::make_shared<const model::ToolAxes>(axes);
  const StockModel wrong = turning_stock(other);
  CHECK_FALSE(right.grid().changed_voxels(wrong.grid()).empty());
}

TEST_CASE("rays through stock that turning moves cut meet its surface", "[property][turning]") {
  for (unsigned seed = 0; seed < 5; ++seed) {
    const StockModel stock = turning_stock(turning_pass(turning_cutters()[seed], seed));
    const simulator::StockRays rays(stock);
    TurningDraw draw(seed);
    int met = 0;
    for (int n = 0; n < 150; ++n) {
      const Vec3 from{draw.between(-12, 12), draw.between(-9, 9), draw.between(-10, 1)};
      const Vec3 along = draw.direction();
      const auto run = rays.run(from, along, 8);
      CHECK(run.material == (stock.exact_value(from) < 0));
      met += run.ends;
      if (run.ends) CHECK(std::abs(stock.exact_value(from + along * run.length_mm)) < 1e-6);
      for (int k = 0; k < 40; ++k) {
        const double phi = stock.exact_value(from + along * (run.length_mm * (k + 0.5) / 40));
        CHECK((run.material ? phi : -phi) <= 2e-7);
      }
    }
    CHECK(met > 50);
  }
}

TEST_CASE("axes that cannot be are refused", "[unit][turning]") {
  Pass pass = turning_pass(turning_cutters()[0], 1);
  model::ToolAxes axes = *pass.axes;
  axes.to.pop_back();
  pass.axes = std::make_shared<const model::ToolAxes>(axes);
  const StockModel block(turning_block(), 1, kTurningBytes);
  CHECK_THROWS_AS(block.cut(pass, {1}), std::invalid_argument);
  CHECK_THROWS_AS(block.forecast(pass, {1}), std::invalid_argument);
}
