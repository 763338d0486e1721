#include "reports/run/patch_figures.h"

#include "tests/reports/sample_result.h"
#include "tests/support/catch.h"

using namespace limitgauge;
using namespace limitgauge::reports;

namespace {

verifier::DeviationField::Sample sample(int patch, float deviation_mm, float area_mm2,
                                        bool reachable = true) {
  verifier::DeviationField::Sample s;
  s.place.patch = patch, s.deviation_mm = deviation_mm;
  s.area_mm2 = area_mm2, s.reachable = reachable;
  return s;
}

std::vector<int> order(const std::vector<PatchFigures>& all) {
  std::vector<int> out;
  for (const PatchFigures& f : all) out.push_back(f.patch);
  return out;
}

}  // namespace

TEST_CASE("a patch has the worst of its samples", "[unit][html]") {
  verifier::DeviationField field;
  field.samples = {sample(4, -0.25F, 1), sample(4, 0.5F, 2), sample(4, 8.0F, 5, false),
                   sample(4, -0.125F, 2), sample(1, 0.0625F, 3)};
  const std::vector<PatchFigures> all = patch_figures(field, {});
  REQUIRE(all.size() == 2);
  CHECK(all[0].patch == 4);
  CHECK(all[0].samples == 4);
  CHECK(all[0].gouge_mm == 0.25);
  CHECK(all[0].uncut_mm == 0.5);  // 8 mm stand where the cutter cannot reach
  CHECK(all[0].area_mm2 == 10);
  CHECK(all[0].unreachable_mm2 == 5);
  CHECK(all[0].unreachable_share() == 0.5);
  CHECK(all[1].gouge_mm == 0);
  CHECK(all[1].uncut_mm == 0.0625);
  CHECK(patch_figures({}, {}).empty());
}

TEST_CASE("the patches of a triangle count as one", "[unit][html]") {
  verifier::DeviationField field;
  field.samples = {sample(3, -0.25F, 1), sample(5, 0.5F, 2), sample(2, 0.125F, 4)};
  const std::vector<PatchFigures> all = patch_figures(field, {}, kPatchesOfTriangle);
  REQUIRE(order(all) == std::vector{3, 0});
  CHECK(all[0].samples == 2);
  CHECK(all[0].gouge_mm == 0.25);
  CHECK(all[0].uncut_mm == 0.5);
  CHECK(all[0].area_mm2 == 3);
}

TEST_CASE("patches are sorted by how far they use up their limits", "[unit][html]") {
  verifier::DeviationField field;
  field.samples = {sample(0, 0.5F, 1), sample(1, -0.125F, 1), sample(2, -0.25F, 1),
                   sample(3, 0.0F, 1)};
  CHECK(order(patch_figures(field, {})) == std::vector{0, 2, 1, 3});
  // 0.5 of 1 mm, 0.125 and 0.25 of 0.2 mm.
  CHECK(order(patch_figures(field, {true, true, false, 0.2, 1, 0})) == std::vector{2, 1, 0, 3});
  // What is not limited does not count, and any gouge is far beyond a limit of nothing.
  CHECK(order(patch_figures(field, {false, true, false, 0, 1, 0})) == std::vector{0, 1, 2, 3});
  CHECK(order(patch_figures(field, {true, true, false, 0, 1, 0})) == std::vector{2, 1, 0, 3});
}

TEST_CASE("the patches of a stage share out its surface", "[unit][html]") {
  const RunResult result = sample_result(Outcome::failed, 9);
  const StageResult& stage = result.stages[1];
  const std::vector<PatchFigures> all = patch_figures(stage.ran->deviation->field, stage.limits);
  REQUIRE(all.size() == 30);
  double gouge = 0, unreachable = 0;
  for (const PatchFigures& f : all) {
    CHECK(f.samples == 81);
    CHECK(f.area_mm2 == Approx(80.0 * 65 / 30).epsilon(1e-5));  // single precision, 81 terms
    gouge = std::max(gouge, f.gouge_mm);
    unreachable += f.unreachable_mm2;
  }
  // The sample's certified lower end is its deepest sample.
  CHECK(gouge == Approx(stage.ran->deviation->gouge_mm.low).epsilon(1e-12));
  CHECK(unreachable == Approx(stage.ran->deviation->unreachable_area_mm2));
  // The dent of stage 2 lies at x = -12, y = 9: column 2, row 3 of six by five patches.
  CHECK(all.front().patch == 3 * 6 + 2);
}
