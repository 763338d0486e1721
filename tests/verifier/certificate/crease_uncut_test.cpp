// Material over sharp convex edges: a cutter rides on an edge along every normal between the faces.
#include <cmath>
#include <numbers>

#include "tests/support/catch.h"
#include "tests/support/judging.h"
#include "tests/support/part_cages.h"
#include "tests/support/solid_meshes.h"

namespace limitgauge::verifier {
namespace {

using model::Vec3;
using namespace tests;

/// Places within 1e-4 mm of a contact count as reached.
constexpr double kContact_mm = 1e-4;

model::Cutter taper_cutter(double diameter_mm, double angle_deg) {
  return {"taper", model::CutterType::taper, diameter_mm, diameter_mm / 2, angle_deg, 30, {}, {}};
}

/// Rows of a ball along the floor on both sides of ridges, from `clear_mm` off their feet on.
model::Toolpath floor_beside(const Ridges& r, double clear_mm, double step_mm) {
  const double foot = r.count * r.pitch_mm / 2, end = foot + r.floor_mm, y = r.length_mm;
  model::Toolpath path;
  path.start = {-end - 4, -y, 9};
  for (const double side : {-1.0, 1.0})
    for (double x = foot + clear_mm; x < end + 4; x += step_mm) {
      feed_to(path, {side * x, -y, 9});
      feed_to(path, {side * x, -y, 0});
      feed_to(path, {side * x, y, 0});
      feed_to(path, {side * x, y, 9});
    }
  return path;
}

model::Toolpath nothing() {
  return moves_through({{-20, -20, 30}, {20, 20, 30}});
}

}  // namespace

TEST_CASE("ridges that were never touched are uncut by what stands on them",
          "[unit][definition2]") {
  // 90 degrees, 1 mm apart, 0.5 mm high, the block 2 mm higher; the floor beside them is milled by
  // a ball of D6, whose flank stays off the ridges. The ball rides on an outer ridge leaning
  // outwards until it touches the floor: its centre 3 mm over it and 2.5 mm over the edge, so the
  // run through the block is 2 / (2.5 / 3) = 2.4 mm; straight up it is 2.
  const Ridges ridges{5, 1, 45, 8, 9};
  const ReferenceSurface surface(ridge_cage(ridges));
  const auto block = block_between({-11.5, -4, -4}, {11.5, 4, 2.5});
  const std::vector<Pass> passes = {pass_of(ball_cutter(3), floor_beside(ridges, 4.5, 0.1))};
  const Judged judged = judge(surface, block, passes, uncut_gate(0.5));
  CAPTURE(judged.deviation.uncut_mm.low, judged.deviation.uncut_mm.high);
  CHECK(judged.decision.verdict == Verdict::fail);
  // Beside the ridges the ball leaves the floor, as far in as it could have touched it: there the
  // block stands 2.5 mm high, which is more.
  const double truth = 2.5;
  const StageDeviation d = measured(surface, block, passes, 0.01);
  CAPTURE(d.uncut_mm.low, d.uncut_mm.high);
  CHECK(d.uncut_mm.low >= 2 / (2.5 / 3));
  CHECK(d.uncut_mm.low <= truth + kContact_mm);
  CHECK(d.uncut_mm.high >= truth - 1e-9);
  CHECK(d.uncut_mm.width() <= 0.01);
}

TEST_CASE("one roof under a ball that cuts nothing is uncut by all that stands on it",
          "[unit][definition2]") {
  const Ridges roof{1, 1, 50, 6, 3};  // 80 degrees at the top
  const ReferenceSurface surface(ridge_cage(roof));
  const auto block = block_between({-4, -4, -4}, {4, 4, roof.height_mm() + 1.5});
  const Judged judged =
      judge(surface, block, {pass_of(ball_cutter(3), nothing())}, uncut_gate(0.5));
  CHECK(judged.decision.verdict == Verdict::fail);
  CHECK(judged.deviation.uncut_mm.low > 0.5);
}

TEST_CASE("a taper that goes between ridges reaches their edges too", "[unit][definition2]") {
  // Five ridges of 80 degrees; the taper mills the floor and the block stands on the ridges.
  const Ridges ridges{5, 1, 50, 6, 6};
  const ReferenceSurface surface(ridge_cage(ridges));
  const auto block = block_between({-8.5, -3.5, -4}, {8.5, 3.5, ridges.height_mm() + 1});
  const std::vector<Pass> passes = {pass_of(taper_cutter(1, 15), floor_beside(ridges, 1.5, 0.05))};
  const Judged judged = judge(surface, block, passes, uncut_gate(0.5));
  CAPTURE(judged.deviation.uncut_mm.low, judged.deviation.uncut_mm.high);
  CHECK(judged.decision.verdict == Verdict::fail);
  CHECK(judged.deviation.uncut_mm.low > 0.5);
}

TEST_CASE("over rims and corners of a boss the run is the longest between the faces' normals",
          "[unit][definition2]") {
  // All faces keep 0.2 mm: over an edge that is 0.2·√2, over a corner 0.2·√3.
  const double off = 0.2, half = 2, r = 2, out = half + off + r;
  const ReferenceSurface surface(boss_cage({{-half, -half, -2}, {half, half, 0}}));
  const auto block = block_between({-5, -5, -6}, {5, 5, 1});
  model::Toolpath path = moves_through({{-out, -out, 9},
                                        {-out, -out, -2.5},
                                        {out, -out, -2.5},
                                        {out, out, -2.5},
                                        {-out, out, -2.5},
                                        {-out, -out, -2.5},
                                        {-9, -9, off}});
  for (const double y : {-4.0, -2.0, 0.0, 2.0, 4.0})
    for (const double x : {-9.0, 9.0, -9.0}) feed_to(path, {x, y, off});
  const std::vector<Pass> passes = {pass_of(flat_cutter(r), path)};
  const double truth = off * std::sqrt(3.0);
  const StageDeviation d = measured(surface, block, passes, 0.002);
  CAPTURE(d.uncut_mm.low, d.uncut_mm.high, truth);
  CHECK(d.uncut_mm.low <= truth + 1e-9);
  CHECK(d.uncut_mm.high >= truth - 1e-9);
  CHECK(d.uncut_mm.width() <= 0.002);
  CHECK(d.gouge_mm.low == 0);
  // The faces and the edges alone would pass.
  CHECK(judge(surface, block, passes, uncut_gate(0.3)).decision.verdict == Verdict::fail);
  CHECK(judge(surface, block, passes, uncut_gate(0.36)).decision.verdict == Verdict::pass);
}

TEST_CASE("material that touches an edge of the part and no more stands over it",
          "[unit][definition2]") {
  // A step 1 mm down. A flat mills the upper face up to the edge, a disc of 1 mm the lower one from
  // the wall on, under a bar that stays: 2 by 1 mm, whose lower corner lies on the edge. A ball
  // could ride on the edge along every normal, so the run is the bar's diagonal.
  const double wide = 2, tall = 1;
  const ReferenceSurface surface(drawn_outline({{-4, 0}, {0, 0}, {0, -1}, {wide, -1}}, 6));
  const auto block = block_between({-4, -3, -4}, {wide, 3, tall});
  model::Cutter disc = flat_cutter(2);
  disc.flute_length_mm = 1, disc.shank = {{0.2, 20}};
  const auto along = [](const std::vector<double>& xs, double z) {
    std::vector<Vec3> tips = {{xs.front(), -9, z}};
    for (const double x : xs)
      tips.push_back({x, -9, z}), tips.push_back({x, 9, z}), tips.push_back({x, -9, z});
    return moves_through(tips);
  };
  const std::vector<Pass> passes = {pass_of(flat_cutter(2), along({-2, -4}, 0)),
                                    pass_of(disc, along({2, 3}, -1)),
                                    pass_of(ball_cutter(0.8), nothing())};
  const Judged judged = judge(surface, block, passes, uncut_gate(0.05));
  CAPTURE(judged.deviation.uncut_mm.low, judged.deviation.uncut_mm.high);
  CHECK(judged.decision.verdict == Verdict::fail);
  CHECK(judged.deviation.uncut_mm.low == Approx(std::hypot(wide, tall)).epsilon(0.05));
}

TEST_CASE("under the rim of a hole the normals of its walls alone are in reach",
          "[unit][definition2][slow]") {
  // Below the plate 1 mm of stock stands. A run from the lower rim that leans downwards by however
  // little passes under the wall opposite and on through that layer, but no flat touches the rim
  // so: across the hole stand 2 r cos(π/n), and nowhere more.
  constexpr double kRadius_mm = 3;
  constexpr int kSides = 8;
  // Of a wall square to an axis runs from its lower edge end on that of the wall opposite exactly.
  const double first_step = GENERATE(0.0, 0.5);
  const ReferenceSurface plate(plate_with_hole(kSides, kRadius_mm, 10, 10, first_step));
  const auto block = block_between({-10, -10, -1}, {10, 10, 10});
  const std::vector<Pass> passes = {pass_of(flat_cutter(2.5), nothing())};
  const StageDeviation d = measured(plate, block, passes, 0.001);
  CAPTURE(first_step, d.uncut_mm.low, d.uncut_mm.high);
  const double across_mm = 2 * kRadius_mm * std::cos(std::numbers::pi / kSides);
  CHECK(d.uncut_mm.low == Approx(across_mm).margin(1e-5));
  CHECK(d.uncut_mm.high >= across_mm);
  CHECK(d.uncut_mm.width() <= 0.001);
  CHECK(d.cells < 200'000);
}

}  // namespace limitgauge::verifier
