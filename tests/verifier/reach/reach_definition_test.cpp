// What counts as reachable, by whom, and what is said of the rest.
#include <algorithm>
#include <cmath>

#include "model/part/cutter.h"
#include "tests/support/catch.h"
#include "tests/support/judging.h"
#include "tests/support/part_cages.h"

namespace limitgauge::verifier {
namespace {

using model::Vec3;
using namespace tests;

model::Toolpath nothing() {
  return moves_through({{-20, -20, 30}, {20, 20, 30}});
}

/// Rows of a flat at one height over [−9, 9]².
model::Toolpath face_at(double z) {
  return raster(9, 1, 18, [=](double, double) { return z; });
}

/// A ledge 1 mm thick that hangs 2 mm over a floor 3 mm below its top, over x < 0.
model::Cage ledge_cage() {
  return drawn_outline({{-5, 0}, {0, 0}, {0, -1}, {-2, -1}, {-2, -3}, {5, -3}}, 6);
}

bool says(const GateDecision& decision, const std::string& what) {
  return std::any_of(decision.reasons.begin(), decision.reasons.end(),
                     [&](const std::string& r) { return r.find(what) != std::string::npos; });
}

}  // namespace

TEST_CASE("a bowl that only the first tool reaches stays uncut, in either order of tools",
          "[unit][definition2]") {
  // z = x²/20: curvature radius 10. A ball of 15 rests on the rims at x = ±6, z = 1.8: its centre
  // stands at 1.8 + √(15² − 6²), its tip 15 below. The ball of 3 reaches everywhere and cuts
  // nothing.
  const double tip = 1.8 + std::sqrt(225.0 - 36) - 15;
  const ReferenceSurface bowl(trough_cage(6, 0.05));
  const auto block = block_between({-6.01, -6.01, -4}, {6.01, 6.01, 3});
  const Pass small = pass_of(ball_cutter(3), nothing());
  const Pass large = pass_of(ball_cutter(15), moves_through({{0, -30, tip}, {0, 30, tip}}));
  for (const auto& passes : {std::vector{small, large}, {large, small}}) {
    const Judged judged = judge(bowl, block, passes, uncut_gate(0.1));
    CHECK(judged.decision.verdict == Verdict::fail);
    const StageDeviation d = measured(bowl, block, passes, 0.005);
    CAPTURE(tip, d.uncut_mm.low, d.uncut_mm.high);
    CHECK(d.uncut_mm.low <= tip + 1e-9);
    CHECK(d.uncut_mm.high >= tip - 1e-9);
    CHECK(d.uncut_mm.width() <= 0.005);
  }
}

TEST_CASE("where nothing can be reached, nothing passes, by name", "[slow][definition2]") {
  const ReferenceSurface plane(flipped(plane_cage(5, 0, 0)));
  const auto block = block_between({-6, -6, -6}, {6, 6, 5});
  for (const auto& cutter : {ball_cutter(3), flat_cutter(2)}) {
    const Judged judged =
        judge(plane, block, {pass_of(cutter, face_at(0))}, both_gates(0.05, 0.05));
    CHECK(judged.decision.verdict == Verdict::fail);
    CHECK(says(judged.decision, "reach"));
    CHECK(judged.deviation.reachable_area_mm2 == 0);
    CHECK(judged.deviation.unreachable_area_mm2 == Approx(100).epsilon(1e-3));
  }
}

TEST_CASE("a stage of a drill alone passes where it touches, and not from behind",
          "[unit][definition2]") {
  const model::Cutter drill = model::parse_cutter("drill:D=4,angle=118,L=60");
  // The tip goes down to the plane, three times; the block ends 1 mm over it, or 5 mm below.
  model::Toolpath spots = moves_through({{0, 0, 9}});
  for (const double x : {-2.0, 0.0, 2.0})
    for (const Vec3& to : {Vec3{x, 0, 9}, {x, 0, 0}, {x, 0, 9}}) feed_to(spots, to);
  const std::vector<Pass> passes = {pass_of(drill, spots)};
  const ReferenceSurface plane(plane_cage(5, 0, 0)), behind(flipped(plane_cage(5, 0, 0)));
  const auto block = block_between({-5, -5, -5}, {5, 5, 1});
  CHECK(judge(plane, block, passes, gouge_gate(0.05)).decision.verdict == Verdict::pass);
  CHECK(judge(plane, block, passes, both_gates(0.05, 2)).decision.verdict == Verdict::pass);
  CHECK(judge(plane, block, passes, both_gates(0.05, 0.05)).decision.verdict == Verdict::fail);
  for (const GateLimits& limits : {gouge_gate(0.05), both_gates(0.05, 0.05)})
    CHECK(
        judge(behind, block_between({-5, -5, -5}, {5, 5, 0.5}), passes, limits).decision.verdict ==
        Verdict::fail);
}

TEST_CASE("a second sheet wound the other way is unreachable, and can be gated",
          "[unit][definition2]") {
  const ReferenceSurface sheets(
      together(plane_cage(3, 0, 0), flipped(placed(plane_cage(3, 0, 0), {1, 0, {7, 0, 0}}))));
  const auto block = block_between({-4, -4, -6}, {11, 4, 5});
  // The flat mills the first sheet clean; 5 mm stay on the second.
  const std::vector<Pass> passes = {pass_of(
      flat_cutter(2), raster(6, 0.5, 12, [](double x, double) { return x < 1.6 ? 0.0 : 9; }))};
  GateLimits limits = uncut_gate(0.05);
  limits.has_unreachable = true, limits.unreachable = 0.05;
  const Judged judged = judge(sheets, block, passes, limits);
  CHECK(judged.deviation.reachable_area_mm2 == Approx(36).epsilon(0.01));
  CHECK(judged.deviation.unreachable_area_mm2 == Approx(36).epsilon(0.01));
  CHECK(judged.decision.verdict == Verdict::fail);
  CHECK(says(judged.decision, "reach"));
}

TEST_CASE("material under a ledge is not charged to what the cutter reaches",
          "[unit][definition2]") {
  // The flat mills top and floor, and the ledge's front by 0.4 µm more than it should, past
  // what contact within 1e-4 mm takes in; 2 mm stand under the ledge.
  const ReferenceSurface ledge(ledge_cage());
  const auto block = block_between({-5.5, -3.5, -7}, {5.5, 3.5, 0.5});
  const double over = 0.0004, x = 2 - over;
  model::Toolpath path = face_at(0);
  for (const double at : {x, x + 2, x + 4})
    for (const Vec3& to : {Vec3{at, -9, 9}, {at, -9, -3}, {at, 9, -3}, {at, 9, 9}})
      feed_to(path, to);
  const std::vector<Pass> passes = {pass_of(flat_cutter(2), path)};
  const Judged judged = judge(ledge, block, passes, both_gates(0.05, 0.05));
  CAPTURE(judged.deviation.uncut_mm.low, judged.deviation.uncut_mm.high,
          judged.deviation.gouge_mm.low, judged.deviation.gouge_mm.high);
  CAPTURE(judged.decision.reasons);
  // Nothing is charged to the reachable floor.
  CHECK(judged.decision.verdict == Verdict::pass);
  CHECK(judged.deviation.gouge_mm.low <= over + 1e-9);
  CHECK(judged.deviation.gouge_mm.high >= over - 1e-9);
  // Floor and ledge's underside of 2 mm, wall of 2 mm, 6 mm long.
  CHECK(judged.deviation.unreachable_area_mm2 == Approx(36).epsilon(0.1));
  // Left out is what cannot be reached, but it can be gated.
  GateLimits limits = both_gates(0.05, 0.05);
  limits.has_unavoidable = true, limits.unavoidable_mm = 0.3;
  CHECK(decide(judged.deviation, limits).verdict == Verdict::fail);
}

TEST_CASE("a cutter with a neck reaches under a ledge, one without does not",
          "[unit][definition2][slow]") {
  const ReferenceSurface ledge(ledge_cage());
  const auto block = block_between({-5.5, -3.5, -7}, {5.5, 3.5, 0.5});
  model::Cutter t_slot = flat_cutter(3);  // 2 mm beyond a neck of 1 mm radius
  t_slot.flute_length_mm = 1, t_slot.shank = {{2, 20}};
  const double over = 0.0004;
  model::Toolpath path = face_at(0);
  for (const double at : {3 - over, 5.0, 7.0})
    for (const Vec3& to : {Vec3{at, -9, 9}, {at, -9, -3}, {at, 9, -3}, {at, 9, 9}})
      feed_to(path, to);
  const Pass milled = pass_of(flat_cutter(3), path);
  const Judged with_neck =
      judge(ledge, block, {milled, pass_of(t_slot, nothing())}, uncut_gate(0.05));
  CHECK(with_neck.decision.verdict == Verdict::fail);
  CHECK(with_neck.deviation.uncut_mm.low > 0.05);
  // A holder that the ledge keeps out keeps nothing out of reach.
  model::Cutter held = t_slot;
  held.shank = {{2, 1.5}}, held.holder = {{12, 20}};
  const Judged with_holder =
      judge(ledge, block, {milled, pass_of(held, nothing())}, uncut_gate(0.05));
  CHECK(with_holder.decision.verdict == Verdict::fail);
  CHECK(with_holder.deviation.proven_reach.unreachable_mm2 ==
        with_neck.deviation.proven_reach.unreachable_mm2);
  const Judged without = judge(ledge, block, {milled}, uncut_gate(0.05));
  CHECK(without.decision.verdict == Verdict::pass);
}

}  // namespace limitgauge::verifier
