// Parts that lie turned, in setups and on machines with rotary axes: a share of what
// limitgauge_defects --jobs goes through, and the harness's own kinematics.
#include <algorithm>

#include "tests/defects/orientations/lying_bench.h"
#include "tests/defects/orientations/lying_suite.h"
#include "tests/support/catch.h"
#include "tests/support/effort.h"

namespace limitgauge::tests::defects {
namespace {

void require_same(const model::Vec3& a, const model::Vec3& b) {
  CAPTURE(a.x, a.y, a.z, b.x, b.y, b.z);
  CHECK(distance(a, b) < 1e-12);
}

/// A over C as on a trunnion, with round numbers.
Machine trunnion() {
  Machine m;
  m.axes = {Rotary{'A', {1, 0, 0}, {0, 0, -10}}, Rotary{'C', {0, 0, 1}, {5, 0, 0}}};
  m.length_mm = 80;
  return m;
}

}  // namespace

TEST_CASE("the harness's machine stands where its axes say by hand", "[unit]") {
  Machine m = trunnion();
  // C takes (6, 0, 0) about (5, 0) to (5, 1, 0), A that about Y = 0, Z = -10 to (5, -10, -9).
  require_same(m.joints_mm({6, 0, 0}, {90, 90}), {5, -10, -9});
  require_same(m.tip_mm({5, -10, -9}, {90, 90}), {6, 0, 0});
  // A lays the part's Z along the machine's -Y: the tool comes along the part's Y.
  require_same(m.upright({90, 0}).direction_back({0, 0, 1}), {0, 1, 0});
  m.chain = Chain::head_head;
  m.axes = {Rotary{'C', {0, 0, 1}, {}}, Rotary{'B', {0, 1, 0}, {}}};
  // B by 90 lays the tool along X, C takes that to Y: the tip is the tool's length before it.
  require_same(m.arm_mm({90, 90}), {0, -80, 0});
  require_same(m.upright({90, 90}).direction_back({0, 0, 1}), {0, 1, 0});
}

TEST_CASE("planted defects are found where parts lie turned, and their twins pass", "[property]") {
  const std::vector<LyingPlan> plans = lying_plans(1, 200, 60);
  // One in a setup and one on a machine, both small, or every fifth with all that is planted there.
  const auto end = static_cast<std::size_t>(by_effort(26, 60)),
             every = static_cast<std::size_t>(by_effort(23, 5)),
             kinds = static_cast<std::size_t>(by_effort(1, 4));
  for (std::size_t k = 2; k < end; k += every) {
    LyingPlan plan = plans[k];
    plan.kinds.resize(std::min(kinds, plan.kinds.size()));
    for (const LyingResult& r : run_lying(plan, {})) {
      CAPTURE(r.label, r.seed, r.harmed, name(r.kind), r.size, r.verdict, r.process, r.broken);
      CAPTURE(r.gouge.truth_mm, r.gouge.certified.low, r.gouge.certified.high, r.gouge.gate_mm);
      CAPTURE(r.uncut.truth_mm, r.uncut.certified.low, r.uncut.certified.high, r.uncut.gate_mm);
      CHECK(r.good());
    }
  }
}

}  // namespace limitgauge::tests::defects
