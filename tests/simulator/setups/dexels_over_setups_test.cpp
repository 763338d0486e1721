// The second stock model over a change of setup: lines of the setup before against the turned level
// set, and lines that are taken from it.
#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <string>

#include "simulator/instrument/dexel_agreement.h"
#include "simulator/instrument/dexels_from.h"
#include "simulator/process/process_check.h"
#include "simulator/stock/material.h"
#include "simulator/tolerance.h"
#include "tests/simulator/setups/turned_bench.h"
#include "tests/support/catch.h"
#include "tests/support/effort.h"

namespace {

using namespace limitgauge;
using model::Pose;
using model::Vec3;
using simulator::compare_stocks;
using simulator::dexels_from;
using simulator::DexelStock;
using simulator::Pass;
using simulator::StockAgreement;
using simulator::StockModel;
using namespace simulator::test;

constexpr std::size_t kAllLines = 1000000;
constexpr double kSetupVoxel = 0.6, kSetupSpacing = 0.37;

std::string told(const StockAgreement& a) {
  std::ostringstream text;
  text << "end " << a.worst_end_mm << " side " << a.worst_side_mm << " at " << a.worst_at.x << " "
       << a.worst_at.y << " " << a.worst_at.z << ", volumes " << a.level_set_volume_mm3 << " "
       << a.dexel_volume_mm3 << ", errors " << a.level_set_error_mm3 << " " << a.dexel_error_mm3;
  return text.str();
}

/// Upright moves in the frame of the second setup, near the middle of its stock.
Pass second_pass(const model::Cutter& c, const StockModel& stock, unsigned seed) {
  const model::Box3& box = stock.material().raw().box();
  PlaceDraw draw(box, seed);
  PathBuilder b(Vec3{box.centre().x, box.centre().y, box.high.z + 5});
  for (int i = 0; i < 25; ++i) {
    Vec3 to = draw();
    to.z = std::max(to.z, box.high.z - 4);
    b.feed(to);
  }
  return b.pass(c);
}

}  // namespace

namespace {

void hold_against_turned(const TurnedCase& t) {
  const Pose& pose = t.to.pose;
  const Pass top = moves_of_all_kinds(t.cutter, t.seed);
  const DexelStock before = DexelStock(setup_block(), kSetupSpacing).cut(top, {2}).stock;
  const StockModel after =
      StockModel(turned(setup_block(), pose), kSetupVoxel, kSetupBytes).cut(placed(top, pose), {2});
  const auto held = compare_stocks(before, after, kAllLines, {2}, {}, pose);
  INFO(t.to.name << ", " << model::to_text(t.cutter) << ": " << told(held));
  CHECK(held.ends > 2000);
  CHECK(held.worst_end_mm < 1e-8);
  CHECK(held.agree());
  // A pose that is off by a hundredth, and one that was forgotten.
  for (const Vec3& off : {Vec3{0.01, 0, 0}, Vec3{0, 0.01, 0}, Vec3{0, 0, -0.01}}) {
    Pose wrong = pose;
    wrong.shift_mm += off;
    const auto found = compare_stocks(before, after, 2000, {2}, held.level_set_volume_mm3, wrong);
    CHECK_FALSE(found.agree());
    CHECK(found.worst_end_mm > 1e-3);
  }
  CHECK_FALSE(compare_stocks(before, after, 2000, {2}, held.level_set_volume_mm3).agree());
}

void take_over_and_cut_on(const TurnedCase& t) {
  const StockModel taken = StockModel(turned(setup_block(), t.to.pose), kSetupVoxel, kSetupBytes)
                               .cut(placed(moves_of_all_kinds(t.cutter, t.seed), t.to.pose), {2});
  const DexelStock lines = dexels_from(taken, kSetupSpacing, {2});
  const auto at_change = compare_stocks(lines, taken, kAllLines, {2});
  INFO(t.to.name << ", " << model::to_text(t.cutter) << ": " << told(at_change));
  CHECK(at_change.ends > 2000);
  CHECK(at_change.worst_end_mm <= simulator::kTakenOver_mm);
  CHECK(at_change.agree());
  const Pass second = second_pass(t.cutter, taken, t.seed + 50);
  const auto at_end =
      compare_stocks(lines.cut(second, {2}).stock, taken.cut(second, {2}), kAllLines, {2});
  INFO("at the end: " << told(at_end));
  CHECK(at_end.level_set_volume_mm3 < at_change.level_set_volume_mm3 - 10);
  CHECK(at_end.agree());
}

}  // namespace

TEST_CASE("the lines of a setup are those of the turned level set", "[property][setups]") {
  for (const TurnedCase& t : few_turned_cases()) hold_against_turned(t);
}

TEST_CASE("lines taken from a level set agree with it, and go on being cut by themselves",
          "[property][setups]") {
  for (const TurnedCase& t : few_turned_cases()) take_over_and_cut_on(t);
}

TEST_CASE("every cutter's lines are right over every change of setup", "[slow][setups]") {
  // Every third meets each cutter and each change of setup.
  const auto cases = turned_cases();
  for (std::size_t i = 0; i < cases.size(); i += tests::by_effort(3, 1)) {
    const TurnedCase& t = cases[i];
    hold_against_turned(t);
    take_over_and_cut_on(t);
  }
}

TEST_CASE("three setups: the passes of both earlier ones lie turned", "[property][setups]") {
  const Pose first = setup_poses()[0].pose, second = setup_poses()[2].pose;
  const Pass a = moves_of_all_kinds(setup_cutters()[1], 31);
  const model::Stock turned_once = turned(setup_block(), first);
  const StockModel two =
      StockModel(turned_once, kSetupVoxel, kSetupBytes).cut(placed(a, first), {2});
  const Pass b = second_pass(setup_cutters()[2], two, 32);
  const DexelStock lines = dexels_from(two, kSetupSpacing, {2}).cut(b, {2}).stock;
  const StockModel three = StockModel(turned(turned_once, second), kSetupVoxel, kSetupBytes)
                               .cut(placed(a, second * first), {2})
                               .cut(placed(b, second), {2});
  const auto held = compare_stocks(lines, three, kAllLines, {2}, {}, second);
  INFO(told(held));
  CHECK(held.agree());
  // Where the turns are put together the wrong way round, or one is left out.
  for (const Pose& wrong : {first * second, second}) {
    const StockModel other = StockModel(turned(turned_once, second), kSetupVoxel, kSetupBytes)
                                 .cut(placed(a, wrong), {2})
                                 .cut(placed(b, second), {2});
    CHECK_FALSE(compare_stocks(lines, other, 2000, {2}, held.level_set_volume_mm3, second).agree());
  }
}

TEST_CASE("lines along walls that were floors are taken over", "[property][setups]") {
  // Rows at round heights: on its side, their floor stands right along lines.
  const Pass rows = raster(cutter(model::CutterType::flat, 4, 9), 8, 1.5, 1,
                           [](double x, double) { return x < 0 ? -3.5 : -5.5; });
  Pose side = model::turn_about({0, 1, 0}, 90);
  const StockModel taken =
      StockModel(turned(setup_block(), side), 0.5, kSetupBytes).cut(placed(rows, side), {2});
  const DexelStock lines = dexels_from(taken, 1, {2});
  bool on_floor = false;
  for (int i = 0; i < lines.nx(); ++i)
    on_floor = on_floor || std::abs(lines.line_at(i, 0).x + 3.5) < 1e-9;
  REQUIRE(on_floor);
  const auto held = compare_stocks(lines, taken, kAllLines, {2});
  INFO(told(held));
  CHECK(held.agree());
}

TEST_CASE("lines taken from a level set are the same for any number of threads",
          "[property][setups]") {
  const NamedPose to = setup_poses()[2];
  const StockModel taken =
      StockModel(turned(setup_block(), to.pose), 0.5, kSetupBytes)
          .cut(placed(moves_of_all_kinds(setup_cutters()[2], 7), to.pose), {2});
  const DexelStock one = dexels_from(taken, 0.5, {1}), three = dexels_from(taken, 0.5, {3});
  REQUIRE(one.nx() == three.nx());
  for (int j = 0; j < one.ny(); ++j)
    for (int i = 0; i < one.nx(); ++i) {
      const auto a = one.material(i, j), b = three.material(i, j);
      REQUIRE(a.size() == b.size());
      for (std::size_t k = 0; k < a.size(); ++k)
        REQUIRE((a[k].low == b[k].low && a[k].high == b[k].high));
    }
}

TEST_CASE("lines refuse a pass that lies turned", "[unit][setups]") {
  const NamedPose to = setup_poses()[0];
  const Pass pass = placed(moves_of_all_kinds(setup_cutters()[0], 7), to.pose);
  CHECK_THROWS_AS(DexelStock(setup_block(), 1).cut(pass, {1}), std::invalid_argument);
}

TEST_CASE("lines refuse a pass that turns its tool as it goes", "[unit][setups]") {
  Pass pass{setup_cutters()[0], placed(moves_of_all_kinds(setup_cutters()[0], 7), {}).path};
  model::ToolAxes axes;
  axes.to.assign(pass.path->moves.size(), axes.start);
  pass.axes = std::make_shared<const model::ToolAxes>(axes);
  CHECK_THROWS_AS(DexelStock(setup_block(), 1).cut(pass, {1}), std::invalid_argument);
}
