// The second instrument of turning passes: it agrees with the level set, and sees what is wrong.
#include "simulator/instrument/turning_agreement.h"

#include "simulator/instrument/dexels_from.h"
#include "tests/simulator/paths.h"
#include "tests/simulator/turning/turning_bench.h"
#include "tests/support/catch.h"

namespace {

using namespace limitgauge;
using model::Pass;
using model::Vec3;
using simulator::DexelStock;
using simulator::StockModel;
using namespace simulator::test;

constexpr double kApart_mm = 0.5;

struct TurningStage {
  DexelStock before{turning_block(), kApart_mm};
  StockModel after;
  DexelStock lines;

  explicit TurningStage(const Pass& pass)
      : after(StockModel(turning_block(), 0.4, std::size_t{1} << 30).cut(pass, {2})),
        lines(dexels_from(after, kApart_mm, {2})) {}
  simulator::StockAgreement held_against(const Pass& pass, unsigned threads = 2) const {
    return compare_turning(before, lines, after, pass, 250, {threads});
  }
};

}  // namespace

TEST_CASE("many poses agree with the level set of turning moves", "[slow][turning]") {
  for (unsigned seed = 0; seed < turning_cutters().size(); ++seed) {
    const Pass pass = turning_pass(turning_cutters()[seed], seed, 20);
    const TurningStage stage(pass);
    const auto found = stage.held_against(pass);
    INFO(model::to_text(pass.cutter)
         << " at " << found.worst_at.x << " " << found.worst_at.y << " " << found.worst_at.z);
    CHECK(found.worst_end_mm == 0);
    CHECK(found.worst_side_mm == 0);
    CHECK(found.agree());
    CHECK(found.lines == 250);
    CHECK(found.ends > 300);
  }
}

TEST_CASE("a stock that was cut with a wrong axis or a wrong tip does not agree",
          "[property][turning]") {
  const Pass pass = turning_pass(turning_cutters()[1], 4, 20);
  const TurningStage stage(pass);
  CHECK(stage.held_against(pass, 1).worst_end_mm == stage.held_against(pass, 2).worst_end_mm);
  model::ToolAxes axes = *pass.axes;
  for (Vec3& axis : axes.to) axis = model::normalized(axis + Vec3{1e-4, 0, 0});
  Pass leaning = pass;
  leaning.axes = std::make_shared<const model::ToolAxes>(axes);
  CHECK(stage.held_against(leaning).worst_end_mm > simulator::kAgreement_mm);
  model::Toolpath path = *pass.path;
  for (model::Move& m : path.moves) m.to.z += 1e-4;
  Pass higher = pass;
  higher.path = std::make_shared<const model::Toolpath>(path);
  CHECK(stage.held_against(higher).worst_end_mm > simulator::kAgreement_mm);
}

TEST_CASE("passes without axes and lines that differ are refused there", "[unit][turning]") {
  const Pass pass = turning_pass(turning_cutters()[0], 4, 6);
  const TurningStage stage(pass);
  Pass upright = pass;
  upright.axes.reset();
  CHECK_THROWS_AS(stage.held_against(upright), std::invalid_argument);
  CHECK_THROWS_AS(
      compare_turning(DexelStock(turning_block(), 1), stage.lines, stage.after, pass, 9, {1}),
      std::invalid_argument);
}
