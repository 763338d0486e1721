#include <cmath>
#include <utility>

#include "model/base/error.h"
#include "reports/compare/run_comparison.h"
#include "tests/reports/compare/compare_support.h"
#include "tests/support/catch.h"

using namespace limitgauge;
using namespace limitgauge::reports;
using namespace limitgauge::reports::compare;
using record::RunRecord;
using verifier::Verdict;

TEST_CASE("Verdicts, gates and stages that give way are regressions", "[unit][compare]") {
  const auto worse = [](auto change) {
    RunRecord now = sample_run();
    change(now);
    const Comparison there = compare_runs(sample_run(), now, {});
    CHECK(there.worse == compare_runs(now, sample_run(), {}).better);
    return there.worse;
  };
  CHECK(worse([](RunRecord& r) { r.stages[0].limits.uncut_mm = 0.02; }) == 1);
  CHECK(worse([](RunRecord& r) { r.stages[0].limits.has_gouge = false; }) == 1);
  CHECK(worse([](RunRecord& r) { r.stages[0].limits.coverage = 0.98; }) == 1);
  CHECK(worse([](RunRecord& r) { r.stages[0].limits.uncut_mm = 0.005; }) == 0);
  CHECK(worse([](RunRecord& r) { r.verdict = r.stages[0].verdict = Verdict::indeterminate; }) == 2);
  CHECK(worse([](RunRecord& r) { r.verdict = r.stages[0].verdict = Verdict::fail; }) == 2);
  CHECK(worse([](RunRecord& r) { r.stages[0].measures->process = {{"near_miss", 3}}; }) == 0);
  CHECK(worse([](RunRecord& r) { r.stages[0].measures->process = {{"feed_missing", 3}}; }) == 1);
  RunRecord other = sample_run();
  other.stages[0].name = "other";
  const Comparison renamed = compare_runs(sample_run(), other, {});
  CHECK(renamed.worse == 1);
  REQUIRE(renamed.stages.size() == 2);
  other.job = "another";
  CHECK_THROWS_AS(compare_runs(sample_run(), other, {}), model::InputError);
}

TEST_CASE("Limits of what is out of reach count as any other", "[unit][compare]") {
  const auto limited = [](bool is_share, double limit) {
    RunRecord run = sample_run();
    verifier::GateLimits& limits = run.stages[0].limits;
    limits.has_unreachable = limits.has_unavoidable = true;
    limits.unreachable_is_share = is_share;
    limits.unreachable = limit, limits.unavoidable_mm = 0.3;
    return run;
  };
  CHECK(compare_runs(sample_run(), limited(true, 0.1), {}).better == 2);
  CHECK(compare_runs(limited(true, 0.1), limited(true, 0.2), {}).worse == 1);
  const Comparison other = compare_runs(limited(true, 0.1), limited(false, 10), {});
  CHECK(other.worse == 1);
  CHECK(other.better == 1);
}

TEST_CASE("Limits of the process count as any other", "[unit][compare]") {
  record::RunRecord base = sample_run();
  base.process_limits = {0.01, 0.5, model::Box3{{-10, -10, -5}, {10, 10, 90}}, std::nullopt,
                         std::nullopt};
  const auto judged = [&](const auto& change) {
    record::RunRecord now = base;
    change(*now.process_limits);
    const Comparison there = compare_runs(base, now, {}), back = compare_runs(now, base, {});
    CHECK(there.worse == back.better);
    CHECK(there.better == back.worse);
    return static_cast<int>(there.worse) - static_cast<int>(there.better);
  };
  using Limits = record::ProcessLimits;
  CHECK(judged([](Limits&) {}) == 0);
  CHECK(judged([](Limits& now) { now.contact_tolerance_mm = 5; }) == 1);
  CHECK(judged([](Limits& now) { now.travel_mm->high.x = 11; }) == 1);
  CHECK(judged([](Limits& now) { now.travel_mm->low.y = -11; }) == 1);
  CHECK(judged([](Limits& now) { now.travel_mm->high.z = INFINITY; }) == 1);
  CHECK(judged([](Limits& now) { now.travel_mm.reset(); }) == 6);
  CHECK(judged([](Limits& now) { now.near_miss_mm = 0; }) == 0);
  record::RunRecord now = base;
  now.process_limits->contact_tolerance_mm = 5;
  CHECK(compare_runs(base, now, {}).remarks.at(0).text ==
        "limit of contacts loosened from 10 µm to 5 mm");
  // An earlier version's result does not say them; what is said no more may hold no more.
  now.process_limits.reset();
  CHECK(compare_runs(now, base, {}).judgement() == Judgement::same);
  CHECK(compare_runs(base, now, {}).judgement() == Judgement::worse);
  CHECK(compare_runs(base, now, {}).remarks.at(0).text ==
        "limits that the process is checked against are said no more");
}

TEST_CASE("A fixture that is looked at no more is a limit taken away", "[unit][compare]") {
  RunRecord base = sample_run(), now;
  base.process_limits.emplace();
  base.process_limits->fixtures = {{"vise", "vise.stl", {0, 0, -5}, {}, {}}};
  const auto compared = [&](const std::vector<record::CheckedFixture>& fixtures) {
    now = base;
    now.process_limits->fixtures = fixtures;
    return compare_runs(base, now, {});
  };
  CHECK(compared({}).worse == 1);
  CHECK(compare_runs(now, base, {}).better == 1);
  CHECK(compared(*base.process_limits->fixtures).remarks.empty());
  // In another place it is neither more nor less to run into.
  const Comparison moved = compared({{"vise", "vise.stl", {0, 0, -40}, "second", "A"}});
  CHECK(moved.judgement() == Judgement::same);
  CHECK(moved.remarks.at(0).text ==
        "fixture vise was at 0, 0, -5 mm, is at 0, 0, -40 mm in setup second with axis A");
  CHECK(compared({{"vise", "other.stl", {0, 0, -5}, {}, {}}}).remarks.at(0).text ==
        "fixture vise was vise.stl, is other.stl");
  // An earlier version's result does not say them; what is said no more may be looked at no more.
  now = base;
  now.process_limits->fixtures.reset();
  CHECK(compare_runs(now, base, {}).judgement() == Judgement::same);
  CHECK(compare_runs(base, now, {}).judgement() == Judgement::worse);
}

TEST_CASE("The range of a rotary axis is a limit at each end", "[unit][compare]") {
  RunRecord base = sample_run();
  base.process_limits.emplace();
  base.process_limits->rotary_axes = {{"A", false, {1, 0, 0}, {0, 0, -50}, -30, 120}};
  const auto judged = [&](const auto& change) {
    RunRecord now = base;
    change(now.process_limits->rotary_axes->at(0));
    const Comparison there = compare_runs(base, now, {}), back = compare_runs(now, base, {});
    CHECK(there.worse == back.better);
    return static_cast<int>(there.worse) - static_cast<int>(there.better);
  };
  using Axis = record::RotaryAxis;
  CHECK(judged([](Axis&) {}) == 0);
  CHECK(judged([](Axis& a) { a.low_deg = -40; }) == 1);
  CHECK(judged([](Axis& a) { a.low_deg = -20; }) == -1);
  CHECK(judged([](Axis& a) { a.high_deg = INFINITY; }) == 1);
  CHECK(judged([](Axis& a) { a.point_mm.z = -51; }) == 0);
  RunRecord now = base;
  now.process_limits->rotary_axes->at(0).point_mm.z = -51;
  CHECK(compare_runs(base, now, {}).remarks.at(0).text ==
        "how the machine's rotary axes lie has changed");
}

TEST_CASE("How steeply a tool may go down is a limit of its stage", "[unit][compare]") {
  const auto run_with = [](const char* cutter) {
    RunRecord run = sample_run();
    run.stages[0].cutter = cutter;
    return run;
  };
  const RunRecord steep = run_with("flat:D=8,L=20"), ramp = run_with("flat:D=8,L=20,ramp=5"),
                  loose = run_with("flat:D=8,L=20,ramp=30");
  for (const auto& [base, now] : {std::pair(ramp, steep), std::pair(ramp, loose)}) {
    CHECK(compare_runs(base, now, {}).worse == 1);
    CHECK(compare_runs(now, base, {}).better == 1);
    CHECK(compare_runs(now, base, {}).worse == 0);
  }
  // Another cutter is named, not judged; what another version wrote may not be read.
  CHECK(compare_runs(ramp, run_with("flat:D=6,L=20,ramp=5"), {}).worse == 0);
  CHECK(compare_runs(run_with("of tomorrow"), steep, {}).worse == 0);
}

TEST_CASE("A figure beyond its limit is known to a twentieth of itself", "[unit][compare]") {
  const auto gouged = [](double low_mm, double high_mm) {
    RunRecord run = sample_run();
    run.stages[0].measures->deviation->gouge_mm = {low_mm, high_mm};
    return run;
  };
  // A limit ten times as wide has the same cut narrowed further.
  const RunRecord tight = gouged(0.0499, 0.0524), loose = gouged(0.0499, 0.051);
  CHECK(compare_runs(tight, loose, {}).better == 0);
  CHECK(compare_runs(loose, tight, {}).worse == 0);
  // What is wider than that was not narrowed, and what lies apart is another.
  CHECK(compare_runs(tight, gouged(0.0499, 0.08), {}).worse == 1);
  CHECK(compare_runs(tight, gouged(0.06, 0.063), {}).worse == 1);
}

TEST_CASE("What was asked is named where no file shows it", "[unit][compare]") {
  record::RunRecord base = sample_run();
  base.design = {{{-5, -5, 0}, {5, 5, 1}}, 100};
  base.stock = "{\"shape\":\"box\"}", base.programs = "{\"tools\":[]}";
  const auto named = [&](const auto& change) {
    record::RunRecord now = base;
    change(now);
    const Comparison there = compare_runs(base, now, {});
    CHECK(there.worse == 0);
    std::string ids;
    for (const Remark& remark : there.remarks) ids += remark.id + ": " + remark.text + "\n";
    return ids;
  };
  CHECK(named([](RunRecord&) {}) == "");
  // Rounding of what is written out whole.
  CHECK(named([](RunRecord& r) { r.design->area_mm2 += 1e-12; }) == "");
  CHECK(named([](RunRecord& r) { r.design->box_mm.high.x = 2.5; }) ==
        "surface: the design has another box or area: the figures are those of another surface\n");
  CHECK(named([](RunRecord& r) { r.design->area_mm2 = 25; }) ==
        "surface: the design has another box or area: the figures are those of another surface\n");
  CHECK(named([](RunRecord& r) {
          r.overrides = {"fixture.clamp.translate=[400,0,0]", "a=1"};
        }) ==
        "overrides: set on the command line was nothing, is fixture.clamp.translate=[400,0,0], "
        "a=1\n");
  CHECK(named([](RunRecord& r) { r.stock = "{\"shape\":\"cylinder\"}"; }) ==
        "stock: what is stated of the raw stock has changed: the figures are those of another "
        "stock\n");
  CHECK(
      named([](RunRecord& r) { r.programs = "{\"tools\":[1]}"; }) ==
      "programs: what programs were told of zero, offsets, start, control or tools has changed\n");
  CHECK(named([](RunRecord& r) { r.setups = "[]"; }) ==
        "setups: how the setups stand has changed\n");
  // A result of an earlier version may say less.
  CHECK(named([](RunRecord& r) { r.design.reset(), r.stock.clear(), r.programs.clear(); }) == "");
}
