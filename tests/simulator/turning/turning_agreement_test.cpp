// The second instrument of turning passes: it agrees with the level set, and sees what is wrong.
#include "simulator/instrument/turning_agreement.h"

#include <cmath>
#include <numbers>

#include "simulator/instrument/dexels_from.h"
#include "simulator/instrument/turning_removal.h"
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

TEST_CASE("moves that turn by tens of degrees agree", "[property][turning]") {
  // In and out of the block by turns of up to 60 degrees in one move.
  model::Toolpath path;
  path.start = {3.0367, 3.6024, 40};
  auto axes = std::make_shared<model::ToolAxes>();
  axes->start = model::normalized(Vec3{-0.528159474, -0.625942457, 0.573797534});
  const auto go = [&](const Vec3& to, const Vec3& axis) {
    path.moves.emplace_back(to, 500.0F, 1U, model::MoveKind::feed);
    axes->to.push_back(model::normalized(axis));
  };
  go({3.0367, 3.6024, 1.0703}, axes->start);
  go({4.0121, 3.7103, 1.1457}, {-0.782153372, -0.010087321, 0.623004293});
  go({4.0775, -0.7639, 0.6777}, {-0.782153372, -0.010087321, 0.623004293});
  go({-3.2328, -3.2641, 0.0951}, {0.020614767, 0.168246148, 0.985529434});
  go({-3.2328, -3.2641, 40}, {0.020614767, 0.168246148, 0.985529434});
  const Pass pass{model::parse_cutter("flat:D=3,L=5"),
                  std::make_shared<const model::Toolpath>(path),
                  {},
                  false,
                  axes};
  const model::Stock block = model::BoxStock{{-6, -6, -3}, {12, 12, 3.3}};
  constexpr double kFine_mm = 0.1;
  const DexelStock before(block, kFine_mm);
  const StockModel after = StockModel(block, 0.4, std::size_t{1} << 30).cut(pass, {2});
  const DexelStock lines = dexels_from(after, kFine_mm, {2});
  const auto found = compare_turning(before, lines, after, pass, 4000, {2});
  CHECK(found.worst_end_mm == 0);
  CHECK(found.worst_side_mm == 0);
  CHECK(found.ends > 4000);
}

TEST_CASE("sharp edges that lean agree on straight moves far longer than they are",
          "[property][turning]") {
  // A place a nanometre inside of what the edge cuts is held for two micrometres of the way.
  const double lean = GENERATE(5.0, 20.0, 30.0) * std::numbers::pi / 180;
  const std::string cutter = GENERATE("flat:D=6,L=12", "drill:D=6,angle=118,L=12");
  const Vec3 axis{-std::sin(lean), 0, std::cos(lean)};
  model::Toolpath path;
  path.start = {-60, 0.3, 0.05};
  auto axes = std::make_shared<model::ToolAxes>();
  axes->start = axis;
  path.moves.emplace_back(Vec3{20, 0.3, 0.05}, 500.0F, 1U, model::MoveKind::feed);
  axes->to.push_back(axis);
  path.moves.emplace_back(Vec3{30, 0.3, 0.05}, 500.0F, 2U, model::MoveKind::feed);
  axes->to.push_back(model::normalized(axis + Vec3{0.0175, 0, 0}));
  const Pass pass{
      model::parse_cutter(cutter), std::make_shared<const model::Toolpath>(path), {}, false, axes};
  const model::Stock block = model::BoxStock{{-10, -4, -4}, {20, 8, 6}};
  const DexelStock before(block, kApart_mm);
  const StockModel after = StockModel(block, 0.4, std::size_t{1} << 30).cut(pass, {2});
  const DexelStock lines = dexels_from(after, kApart_mm, {2});
  const auto found = compare_turning(before, lines, after, pass, 640, {2});
  CAPTURE(cutter, lean, found.worst_at.x, found.worst_at.y, found.worst_at.z);
  CHECK(found.worst_end_mm == 0);
  CHECK(found.worst_side_mm == 0);
  CHECK(found.ends > 640);
}

TEST_CASE("a flat whose axis swings across its way agrees where its edge leaves the floor",
          "[property][turning]") {
  // The floor is what the edge leaves behind it: just above, the level set's nearest face is the
  // cutter's side, along which no way leads into the material.
  const double swing = GENERATE(8.0, 13.0, 20.0) * std::numbers::pi / 180;
  const Vec3 from{0, std::sin(swing), std::cos(swing)}, to{0, -from.y, from.z};
  model::Toolpath path;
  path.start = {-40, 0, -2.2};
  path.moves.emplace_back(Vec3{40, 0, -2.2}, 500.0F, 1U, model::MoveKind::feed);
  const Pass pass{model::parse_cutter("flat:D=6,L=5"),
                  std::make_shared<const model::Toolpath>(path),
                  {},
                  false,
                  std::make_shared<const model::ToolAxes>(model::ToolAxes{from, {to}})};
  const model::Stock block = model::BoxStock{{-15, -10, -5}, {30, 20, 5}};
  const DexelStock before(block, kApart_mm);
  const StockModel after = StockModel(block, 0.5, std::size_t{1} << 30).cut(pass, {2});
  const DexelStock lines = dexels_from(after, kApart_mm, {2});
  const auto found = compare_turning(before, lines, after, pass, 1500, {2});
  CAPTURE(swing, found.worst_at.x, found.worst_at.y, found.worst_at.z);
  CHECK(found.worst_end_mm <= simulator::kAgreement_mm);
  CHECK(found.worst_side_mm <= simulator::kAgreement_mm);
  CHECK(found.ends > 1500);
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

TEST_CASE("what turning moves take adds up and goes to the first that comes there",
          "[property][turning]") {
  const Pass pass = turning_pass(turning_cutters()[1], 6, 12);
  const TurningStage stage(pass);
  const auto found = turning_removal(stage.before, stage.lines, pass, {2});
  const auto alone = turning_removal(stage.before, stage.lines, pass, {1});
  double sum = 0;
  for (std::size_t i = 0; i < found.moves.size(); ++i) {
    sum += found.moves[i].volume_mm3;
    CHECK(found.moves[i].volume_mm3 == alone.moves[i].volume_mm3);
    CHECK(found.moves[i].radial_mm <= 10);
  }
  const double gone = stage.before.volume_mm3() - stage.lines.volume_mm3();
  CHECK(sum == Approx(gone).epsilon(1e-6));
  CHECK(found.totals.volume_mm3 == Approx(sum));
  // The first half of the pass alone takes what its moves take in all of it.
  model::Toolpath path = *pass.path;
  model::ToolAxes axes = *pass.axes;
  path.moves.resize(6), axes.to.resize(6);
  const Pass half{pass.cutter,
                  std::make_shared<const model::Toolpath>(path),
                  {},
                  false,
                  std::make_shared<const model::ToolAxes>(axes)};
  const TurningStage first(half);
  const auto part = turning_removal(first.before, first.lines, half, {2});
  for (std::size_t i = 0; i < part.moves.size(); ++i)
    CHECK(part.moves[i].volume_mm3 ==
          Approx(found.moves[i].volume_mm3).epsilon(0.05).margin(0.02 * gone));
  // A single dive.
  const TurnedMove dive{{0, 0, 5}, {0, 0, -3}, {0, 0, 1}, {0.28, 0, 0.96}};
  const Pass one = with_axes(turning_cutters()[0], {dive});
  const TurningStage dived(one);
  const auto all = turning_removal(dived.before, dived.lines, one, {2});
  CHECK(all.moves[0].axial_mm == Approx(3).margin(0.3));
  CHECK(all.moves[0].rate_mm3_min == Approx(all.moves[0].volume_mm3 * 1000 / 8));
}
