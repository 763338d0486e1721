// What is thinner than it is tall or deep: fins, holes, coarse cusps, plates near the block's
// faces.
#include <algorithm>
#include <cmath>

#include "tests/support/catch.h"
#include "tests/support/judging.h"
#include "tests/support/part_cages.h"

namespace limitgauge::verifier {
namespace {

using model::Vec3;
using namespace tests;

}  // namespace

TEST_CASE("fins between two passes of a flat stand with their height", "[unit][definition2]") {
  const ReferenceSurface plane(plane_cage(5, 0, 0));
  const auto block = block_between({-6, -6, -6}, {6, 6, 5});
  for (const double thick : {0.002, 0.02, 0.05, 0.09, 0.099}) {
    const double x = 4 + thick / 2;
    const std::vector<Pass> passes = {pass_of(flat_cutter(4), moves_through({{-x, -11, 9},
                                                                             {-x, -11, 0},
                                                                             {-x, 11, 0},
                                                                             {-x, 11, 9},
                                                                             {x, 11, 9},
                                                                             {x, 11, 0},
                                                                             {x, -11, 0}}))};
    const Judged judged = judge(plane, block, passes, both_gates(0.05, 0.05));
    CAPTURE(thick, judged.deviation.uncut_mm.low, judged.deviation.uncut_mm.high);
    CHECK(judged.decision.verdict == Verdict::fail);
    CHECK(judged.deviation.uncut_mm.low <= 5);
    CHECK(judged.deviation.uncut_mm.high >= 5);
    CHECK(judged.deviation.gouge_mm.low == 0);
    REQUIRE(!judged.deviation.uncuts.empty());
    const Finding& fin = judged.deviation.uncuts.front();
    CHECK(std::abs(fin.place.point.x) <= thick / 2 + 1e-6);
    CHECK(fin.line > 0);
  }
}

TEST_CASE("holes deeper than wide are gouges of their depth", "[unit][definition2]") {
  const ReferenceSurface plane(plane_cage(5, 0, 0));
  const auto block = block_between({-6, -6, -6}, {6, 6, 0});
  for (const double diameter : {0.05, 0.08, 0.11}) {
    const std::vector<Pass> passes = {pass_of(
        flat_cutter(diameter / 2), moves_through({{1.3, 0.7, 9}, {1.3, 0.7, -4}, {1.3, 0.7, 9}}))};
    const Judged judged = judge(plane, block, passes, gouge_gate(0.06));
    CAPTURE(diameter, judged.deviation.gouge_mm.low, judged.deviation.gouge_mm.high);
    CHECK(judged.decision.verdict == Verdict::fail);
    CHECK(judged.deviation.gouge_mm.low <= 4);
    CHECK(judged.deviation.gouge_mm.high >= 4);
    REQUIRE(!judged.deviation.gouges.empty());
    const Finding& hole = judged.deviation.gouges.front();
    CHECK(level_distance(hole.place.point, {1.3, 0.7, 0}) <= diameter / 2 + 1e-6);
  }
}

TEST_CASE("a fin of the part that was milled away is gouged through", "[slow][definition2]") {
  // 0.09 mm thick and 1 mm tall: 0.09 from its walls, 1 from its top.
  const ReferenceSurface fin(
      drawn_outline({{-4, 0}, {-0.045, 0}, {-0.045, 1}, {0.045, 1}, {0.045, 0}, {4, 0}}, 6));
  const auto block = block_between({-5, -4, -5}, {5, 4, 1});
  const std::vector<Pass> passes = {
      pass_of(flat_cutter(5), moves_through({{0, -20, 0}, {0, 20, 0}}))};
  CHECK(judge(fin, block, passes, gouge_gate(0.08)).decision.verdict == Verdict::fail);
  const StageDeviation d = measured(fin, block, passes, 0.005);
  CAPTURE(d.gouge_mm.low, d.gouge_mm.high);
  CHECK(d.gouge_mm.low <= 1 + 1e-9);
  CHECK(d.gouge_mm.high >= 1 - 1e-9);
}

TEST_CASE("cusps from fine to coarse by their closed form", "[unit][definition2][slow]") {
  // The height of a cusp between balls of radius R a step p apart is R − √(R² − p²/4).
  const ReferenceSurface plane(plane_cage(5, 0, 0));
  const auto block = block_between({-6, -6, -6}, {6, 6, 4});
  for (const auto& [radius, step] :
       {std::pair{3.0, 0.1}, {3.0, 1.0}, {2.0, 3.5}, {1.0, 1.9}, {5.0, 2.5}}) {
    const double half = step * std::ceil(7 / step);
    const std::vector<Pass> passes = {pass_of(
        ball_cutter(radius), raster(half, step, 2 * half, [](double, double) { return 0.0; }))};
    const double cusp = radius - std::sqrt(radius * radius - step * step / 4);
    const double width = std::max(cusp / 1000, 0.0005);
    const StageDeviation d = measured(plane, block, passes, width);
    CAPTURE(radius, step, cusp, d.uncut_mm.low, d.uncut_mm.high);
    CHECK(d.uncut_mm.low <= cusp + 1e-9);
    CHECK(d.uncut_mm.high >= cusp - 1e-9);
    CHECK(d.uncut_mm.width() <= width);
    CHECK(d.reached_resolution);
    CHECK(d.gouge_mm.low == 0);
    CHECK(judge(plane, block, passes, uncut_gate(0.7 * cusp)).decision.verdict == Verdict::fail);
    CHECK(judge(plane, block, passes, uncut_gate(1.3 * cusp)).decision.verdict == Verdict::pass);
  }
}

TEST_CASE("the outside of the block has cut nothing", "[unit][definition2]") {
  // A plate 0.5 mm above the underside of its block, 10 mm of stock on it, nothing cut.
  const ReferenceSurface plane(plane_cage(5, 0, 0));
  const auto block = block_between({-6, -6, -0.5}, {6, 6, 10});
  const std::vector<Pass> passes = {
      pass_of(ball_cutter(3), moves_through({{-9, -9, 20}, {9, 9, 20}}))};
  const Judged judged = judge(plane, block, passes, uncut_gate(0.6));
  CAPTURE(judged.deviation.uncut_mm.low, judged.deviation.uncut_mm.high);
  CHECK(judged.decision.verdict == Verdict::fail);
  CHECK(judged.deviation.uncut_mm.low <= 10);
  CHECK(judged.deviation.uncut_mm.high >= 10);
  const StageDeviation d = measured(plane, block, passes, 0.01);
  CHECK(d.uncut_mm.low == Approx(10).margin(0.01));
  CHECK(d.missing_stock_mm.low == 0);
  CHECK(d.missing_stock_mm.high <= 0.01);
}

TEST_CASE("a gouge out of the underside is as deep as the last of two tools went",
          "[unit][definition2]") {
  // The wide one goes 2 mm out of the block, the narrow one within its track 1 mm further, through
  // what the outside of the block had already.
  const ReferenceSurface plane(plane_cage(5, 0, 0));
  const auto block = block_between({-6, -6, -6}, {6, 6, 0});
  const auto slot = [](double z) { return moves_through({{0, -20, z}, {0, 20, z}}); };
  const std::vector<Pass> wide_first = {pass_of(flat_cutter(2), slot(-8)),
                                        pass_of(flat_cutter(1), slot(-9))},
                          narrow_first = {wide_first[1], wide_first[0]};
  for (const auto& passes : {wide_first, narrow_first}) {
    const StageDeviation d = measured(plane, block, passes, 0.01);
    CAPTURE(d.gouge_mm.low, d.gouge_mm.high);
    CHECK(d.gouge_mm.low <= 9 + 1e-9);
    CHECK(d.gouge_mm.high >= 9 - 1e-9);
    CHECK(d.gouge_mm.width() <= 0.01);
    CHECK(judge(plane, block, passes, gouge_gate(8.5)).decision.verdict == Verdict::fail);
    CHECK(judge(plane, block, passes, gouge_gate(9.5)).decision.verdict == Verdict::pass);
  }
}

TEST_CASE("raw stock that does not cover the part is no program's gouge", "[unit][definition2]") {
  const ReferenceSurface plane(plane_cage(5, 0, 0));
  const auto block = block_between({-6, -6, -6}, {6, 6, -0.3});
  const std::vector<Pass> passes = {
      pass_of(ball_cutter(3), moves_through({{-9, -9, 20}, {9, 9, 20}}))};
  const StageDeviation d = measured(plane, block, passes, 0.001);
  CHECK(d.gouge_mm.high <= 0.001);
  CHECK(d.missing_stock_mm.low <= 0.3);
  CHECK(d.missing_stock_mm.high >= 0.3);
  CHECK(d.missing_stock_mm.low > 0.29);
  CHECK(!d.missing_stock.empty());
}

TEST_CASE("an allowance that the raw stock has no room for is said", "[unit][definition2]") {
  const ReferenceSurface plane(plane_cage(5, 0, 0));
  const auto block = block_between({-6, -6, -6}, {6, 6, 0.5});
  const std::vector<Pass> passes = {
      pass_of(ball_cutter(3), moves_through({{-9, -9, 20}, {9, 9, 20}}))};
  StageCheck check;
  check.resolution_mm = 0.01;
  check.field_spacing_mm = 1;
  const auto missing = [&](double allowance_mm) {
    check.allowance_mm = allowance_mm;
    return measure_stage(plane, block, passes, nullptr, check, {1, nullptr, {}}).missing_allowance;
  };
  CHECK_FALSE(missing(0));
  CHECK_FALSE(missing(0.4));
  CHECK_FALSE(missing(0.5));
  REQUIRE(missing(2));
  CHECK(missing(2)->depth_mm == Approx(1.5).margin(1e-9));
  // Where the stock does not even cover S, no more is missing of the allowance than there is of it.
  const auto low = block_between({-6, -6, -6}, {6, 6, -0.3});
  CHECK(measure_stage(plane, low, passes, nullptr, check, {1, nullptr, {}})
            .missing_allowance->depth_mm == Approx(2).margin(1e-9));
}

TEST_CASE("a bent part beside its block, that the path just touches, is proven clear in few cells",
          "[unit][definition2][slow]") {
  // z = -0.04 x²; the block lies to the right of it. Below S nothing stands and nothing was swept,
  // all the way, while the ball passes at S itself: that takes margins that grow with the way only.
  const double bend = 0.04, half = 6, radius = 3;
  const ReferenceSurface ridge(trough_cage(half, -bend));
  const auto block = block_between({7, -6, -6}, {19, 6, 1});
  const auto tip_x = [&](double x) {
    return x + radius * 2 * bend * x / std::hypot(1, 2 * bend * x);
  };
  const auto tip_z = [&](double x, double) {
    double low = -20, high = 20;  // the contact whose tip stands over x
    for (int k = 0; k < 60; ++k) (tip_x((low + high) / 2) < x ? low : high) = (low + high) / 2;
    return -bend * low * low + radius / std::hypot(1, 2 * bend * low) - radius;
  };
  const std::vector<Pass> passes = {pass_of(ball_cutter(radius), raster(8, 0.25, 16, tip_z))};
  const StageDeviation d = measured(ridge, block, passes, 0.001);
  CHECK(d.gouge_mm.low == 0);
  CHECK(d.gouge_mm.high <= 0.001);
  CHECK(d.missing_stock_mm.low > 1);
  // A quarter of a million; with margins of the way's end from its beginning on they would have to
  // be two hundred times as small.
  CHECK(d.cells < 400'000);
}

TEST_CASE("a block a little too low for its part is said in few cells", "[unit][definition2]") {
  // Over the block the walls' normals lead through air to the wall behind, where the tool was too.
  const ReferenceSurface boss(drawn_outline({{-10, -5}, {-10, 3}, {10, 3}, {10, -5}}, 8));
  const double over_mm = GENERATE(0.02, 0.005);
  const auto block = block_between({-15, -4, -5}, {15, 4, 3 - over_mm});
  const std::vector<Pass> passes = {pass_of(flat_cutter(4), moves_through({{-20, -2, 9},
                                                                           {-20, -2, 3},
                                                                           {20, -2, 3},
                                                                           {20, 2, 3},
                                                                           {-20, 2, 3},
                                                                           {-20, 2, 9},
                                                                           {-14, -9, 9},
                                                                           {-14, -9, -4},
                                                                           {-14, 9, -4},
                                                                           {14, 9, -4},
                                                                           {14, -9, -4},
                                                                           {14, -9, 9}}))};
  const Judged judged = judge(boss, block, passes, gouge_gate(0.01));
  const StageDeviation& d = judged.deviation;
  CHECK(judged.decision.verdict == Verdict::fail);
  CHECK(d.missing_stock_mm.low <= 20);
  CHECK(d.missing_stock_mm.high >= 20);
  CHECK(d.missing_stock_mm.low > 19.9);
  REQUIRE(!d.missing_stock.empty());
  CHECK(d.missing_stock.front().place.point.z >= 3 - over_mm - 1e-6);
  CHECK(d.gouge_mm.low == 0);
  // Ten thousand; without an end to the search in the strips there are half a million.
  CHECK(d.cells < 60'000);
}

}  // namespace limitgauge::verifier
