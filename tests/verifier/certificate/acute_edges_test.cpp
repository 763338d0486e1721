// Edges of the part with less than a right angle of material, and sheets that rise towards their
// rim: the runs beside them leave the material at once, through another face of it.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/support/catch.h"
#include "tests/support/judging.h"
#include "tests/support/part_cages.h"

namespace limitgauge::verifier {
namespace {

using model::Vec3;
using namespace tests;

constexpr double kDegree = std::numbers::pi / 180;

/// Rows along Y that put a ball on an outline of planes wherever it comes down on it.
model::Toolpath rows_on(const std::vector<OutlinePoint>& outline, double radius_mm, double step_mm,
                        double half_mm, double sunk_mm = 0) {
  const auto tip = [&](double x) {
    double highest = -8;
    for (std::size_t k = 0; k + 1 < outline.size(); ++k) {
      const auto [x0, z0] = outline[k];
      const auto [x1, z1] = outline[k + 1];
      const double wide = std::hypot(x1 - x0, z1 - z0), nx = (z0 - z1) / wide,
                   nz = (x1 - x0) / wide;
      // Its centre over the face, or over the face's ends.
      const double share = nz > 0 ? (x - radius_mm * nx - x0) / (x1 - x0) : -1;
      if (share >= 0 && share <= 1)
        highest = std::max(highest, z0 + share * (z1 - z0) + radius_mm * nz - radius_mm);
      for (const auto& [ex, ez] : {outline[k], outline[k + 1]})
        if (std::abs(x - ex) < radius_mm)
          highest = std::max(
              highest, ez + std::sqrt(radius_mm * radius_mm - (x - ex) * (x - ex)) - radius_mm);
    }
    return highest - sunk_mm;
  };
  model::Toolpath path;
  const double end = std::max(-outline.front().x, outline.back().x) + 2 * radius_mm;
  path.start = {-end, -half_mm, 20};
  bool forth = true;
  for (double x = -end; x <= end; x += step_mm, forth = !forth)
    for (const double y : {forth ? -half_mm : half_mm, forth ? half_mm : -half_mm})
      feed_to(path, {x, y, tip(x)});
  return path;
}

/// A ridge with `angle_deg` of material at its edge, 2 mm wide, on a floor.
std::vector<OutlinePoint> ridge_of(double angle_deg) {
  return {{-3, 0}, {-1, 0}, {0, 1 / std::tan(angle_deg / 2 * kDegree)}, {1, 0}, {3, 0}};
}

constexpr double kLong_mm = 4, kRadius_mm = 2;

}  // namespace

TEST_CASE("a part with an acute edge passes where it was cut right", "[unit][definition2]") {
  const double angle = GENERATE(30.0, 60.0, 80.0);
  CAPTURE(angle);
  const auto outline = ridge_of(angle);
  const ReferenceSurface surface(drawn_outline(outline, kLong_mm));
  const auto block = block_between({-3, -2, -4}, {3, 2, outline[2].z + 1});
  const Judged judged =
      judge(surface, block,
            {pass_of(ball_cutter(kRadius_mm), rows_on(outline, kRadius_mm, 0.1, kLong_mm))},
            both_gates(0.02, 0.1));
  const StageDeviation& d = judged.deviation;
  CAPTURE(d.gouge_mm.low, d.gouge_mm.high, d.uncut_mm.low, d.uncut_mm.high);
  CHECK(judged.decision.verdict == Verdict::pass);
  CHECK(d.gouge_mm.low <= 1e-9);
}

TEST_CASE("a gouge along an acute edge goes on as far as the other face", "[unit][definition2]") {
  // Both faces are cut e too deep. A run from one of them crosses its own layer, e, and that of the
  // other, aslant by the angle of the material: e·(1 + 1/cos of it) where nothing is between.
  const double angle = GENERATE(45.0, 60.0, 70.0), sunk = GENERATE(0.004, 0.02);
  CAPTURE(angle, sunk);
  const auto outline = ridge_of(angle);
  const ReferenceSurface surface(drawn_outline(outline, kLong_mm));
  const auto block = block_between({-3, -2, -4}, {3, 2, outline[2].z + 1});
  const double step = 0.02;
  const std::vector<Pass> passes = {
      pass_of(ball_cutter(kRadius_mm), rows_on(outline, kRadius_mm, step, kLong_mm, sunk))};
  const double e = sunk * std::sin(angle / 2 * kDegree),
               truth = std::max(sunk, e * (1 + 1 / std::cos(angle * kDegree)));
  // Rows leave cusps on the faces, which take so much of the run at most.
  const double along = step / std::sin(angle / 2 * kDegree),
               cusp = along * along / (8 * kRadius_mm) * (1 + 1 / std::cos(angle * kDegree));
  const StageDeviation d = measured(surface, block, passes, 0.002);
  CAPTURE(d.gouge_mm.low, d.gouge_mm.high, truth, cusp);
  CHECK(d.gouge_mm.low <= truth + 1e-9);
  CHECK(d.gouge_mm.high >= truth - cusp);
  CHECK(d.gouge_mm.width() <= 0.002);
}

TEST_CASE("a sheet that rises towards its rim, in a block of its own size, is covered by it",
          "[unit][definition2]") {
  const double allowance = GENERATE(0.0, 0.3);
  CAPTURE(allowance);
  const std::vector<OutlinePoint> outline = {{-6, 1.6}, {0, 0}, {6, 1.1}};
  const ReferenceSurface surface(drawn_outline(outline, kLong_mm));
  const auto block = block_between({-6, -2, -4}, {6, 2, 3});
  const Judged judged =
      judge(surface, block,
            {pass_of(ball_cutter(kRadius_mm),
                     rows_on(outline, kRadius_mm + allowance, 0.1, kLong_mm, -allowance))},
            both_gates(0.01, 0.1), allowance);
  const StageDeviation& d = judged.deviation;
  CAPTURE(d.gouge_mm.low, d.gouge_mm.high, d.uncut_mm.low, d.uncut_mm.high, d.missing_stock_mm.low,
          d.missing_stock_mm.high);
  CHECK(judged.decision.verdict == Verdict::pass);
  CHECK(d.missing_stock_mm.high <= 0.01);
}

TEST_CASE("a block that ends short of a falling rim misses the slice",
          "[unit][definition2][slow]") {
  // The block is 0.2 mm too short: from the rim the run enters it after 0.2 / the sine of the
  // slope.
  const std::vector<OutlinePoint> outline = {{-6, 0}, {0, 3}, {6, 0}};
  const ReferenceSurface surface(drawn_outline(outline, kLong_mm));
  const double missing = 0.2, truth = missing / std::sin(std::atan(0.5));
  const auto block = block_between({-6 + missing, -2, -4}, {6, 2, 5});
  const std::vector<Pass> passes = {
      pass_of(ball_cutter(kRadius_mm), rows_on(outline, kRadius_mm, 0.1, kLong_mm))};
  const StageDeviation d = measured(surface, block, passes, 0.002);
  CAPTURE(d.missing_stock_mm.low, d.missing_stock_mm.high, truth);
  CHECK(d.missing_stock_mm.low <= truth + 1e-9);
  // But for the half micrometre beside the rim.
  CHECK(d.missing_stock_mm.high >= truth - 0.0012);
  CHECK(d.missing_stock_mm.width() <= 0.002);
}

}  // namespace limitgauge::verifier
