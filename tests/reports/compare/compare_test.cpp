#include <nlohmann/json.hpp>
#include <random>
#include <sstream>

#include "model/base/error.h"
#include "reports/compare/matching.h"
#include "reports/compare/report.h"
#include "reports/compare/run_comparison.h"
#include "tests/reports/compare/compare_support.h"
#include "tests/support/catch.h"

using namespace limitgauge;
using namespace limitgauge::reports;
using namespace limitgauge::reports::compare;
using record::RunRecord;
using verifier::Interval;

namespace {

RunRecord with_uncut(const Interval& uncut, double deepest_sample_mm) {
  RunRecord run = sample_run();
  run.stages[0].measures->deviation->uncut_mm = uncut;
  run.stages[0].measures->deviation->sampled_mm->high = deepest_sample_mm;
  return run;
}

Judgement uncut(const Interval& base, double base_sample, const Interval& now, double now_sample) {
  return judgement_of("uncut_mm", with_uncut(base, base_sample), with_uncut(now, now_sample));
}

Judgement reversed(Judgement judgement) {
  if (judgement == Judgement::better) return Judgement::worse;
  return judgement == Judgement::worse ? Judgement::better : judgement;
}

std::string text_of(void (*write)(const Comparison&, std::ostream&), const Comparison& comparison) {
  std::ostringstream out;
  write(comparison, out);
  return out.str();
}

}  // namespace

TEST_CASE("A run compared with itself is the same", "[unit][compare]") {
  RunRecord run = sample_run();
  for (int i = 0; i < 40; ++i)  // more at one place than a search looks at
    run.stages[0].measures->deviation->uncuts.push_back(place_at(7, 0.02, 12));
  const Comparison comparison = compare_runs(run, run, {});
  CHECK(comparison.judgement() == Judgement::same);
  CHECK(comparison.worse + comparison.better == 0);
  CHECK(comparison.stages[0].same_findings == 40);
  CHECK(comparison.stages[0].findings.empty());
  CHECK(comparison.stages[0].remarks.empty());
  CHECK(comparison.remarks.empty());
}

TEST_CASE("Certified figures: proved, promised, agreed", "[unit][compare]") {
  const Interval base{0.005, 0.006};
  const double sample = 0.005;
  // Proved, by however little.
  CHECK(uncut(base, sample, {0.00601, 0.0061}, sample) == Judgement::worse);
  // Apart by less than rounding: no proof.
  CHECK(uncut({0.005, 0.005}, sample, {0.0050000001, 0.0050000001}, sample) == Judgement::same);
  // An interval that was blown up promises less, whatever its low is.
  CHECK(uncut(base, sample, {0.005, 0.0071}, sample) == Judgement::worse);
  CHECK(uncut(base, sample, {0, 0.0069}, sample) == Judgement::same);
  // Both ends and the samples: more than a tenth of the resolution each.
  CHECK(uncut(base, sample, {0.0052, 0.0062}, 0.0052) == Judgement::worse);
  CHECK(uncut(base, sample, {0.0052, 0.0062}, sample) == Judgement::same);
  CHECK(uncut(base, sample, {0.00505, 0.0062}, 0.0052) == Judgement::same);
  CHECK(uncut(base, sample, {0.0052, 0.00605}, 0.0052) == Judgement::same);
  const RunRecord grown = with_uncut({0.008, 0.009}, 0.008);
  const FigureChange change = figure(compare_runs(sample_run(), grown, {}), "uncut_mm");
  CHECK(change.floor == 0.001);
  CHECK(change.why == "proved: the new interval lies wholly above the old one");
}

TEST_CASE("Runs of one truth at two resolutions are the same", "[property][compare]") {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> share(0, 1);
  for (int i = 0; i < 2000; ++i) {
    const double truth = 0.02 * share(random), sample = truth * share(random);
    const auto interval = [&](double width) {
      const double low = std::max(truth - width * share(random), 0.0);
      return Interval{low, std::max(truth, low + width * share(random))};
    };
    RunRecord base = with_uncut(interval(0.001), sample);
    RunRecord now = with_uncut(interval(0.003), sample);
    now.stages[0].measures->deviation->resolution_mm = 0.003;
    CHECK(judgement_of("uncut_mm", base, now) == Judgement::same);
    CHECK(judgement_of("uncut_mm", now, base) == Judgement::same);
  }
}

TEST_CASE("A truth that grew by more than both widths is always found", "[property][compare]") {
  std::mt19937 random(8);
  std::uniform_real_distribution<double> share(0, 1);
  const auto around = [&](double truth, double width) {
    const double low = truth - width * share(random);
    return Interval{low, low + width};
  };
  for (int i = 0; i < 2000; ++i) {
    const RunRecord base = with_uncut(around(0.010, 0.001), 0.005);
    const RunRecord now = with_uncut(around(0.01201, 0.001), 0.005);
    CHECK(judgement_of("uncut_mm", base, now) == Judgement::worse);
    CHECK(judgement_of("uncut_mm", now, base) == Judgement::better);
  }
}

TEST_CASE("Turned round, a comparison says the contrary of every figure", "[property][compare]") {
  std::mt19937 random(9);
  std::uniform_real_distribution<double> share(0, 1);
  const auto any = [&] {
    RunRecord run = sample_run();
    record::DeviationMeasures& m = *run.stages[0].measures->deviation;
    const double at = 0.01 * share(random);
    m.uncut_mm = {at, at + 0.002 * share(random)};
    m.sampled_mm = Interval{0.004 * (share(random) - 0.5), at};
    m.p01_mm = 0.002 * (share(random) - 0.5);
    m.p99_mm = 0.002 * (share(random) - 0.5);
    m.rms_mm = 0.001 * share(random);
    m.coverage = share(random);
    return run;
  };
  for (int i = 0; i < 500; ++i) {
    const RunRecord a = any(), b = any();
    const Comparison there = compare_runs(a, b, {}), back = compare_runs(b, a, {});
    for (std::size_t k = 0; k < there.stages[0].figures.size(); ++k)
      CHECK(there.stages[0].figures[k].judgement == reversed(back.stages[0].figures[k].judgement));
  }
}

TEST_CASE("Statistics, coverage, time and effort have floors of their own", "[unit][compare]") {
  const auto judged = [](const std::string& id, auto change) {
    RunRecord now = sample_run();
    change(*now.stages[0].measures);
    return judgement_of(id, sample_run(), now);
  };
  using M = record::StageMeasures;
  CHECK(judged("rms_mm", [](M& m) { m.deviation->rms_mm += 0.00009; }) == Judgement::same);
  CHECK(judged("rms_mm", [](M& m) { m.deviation->rms_mm += 0.00011; }) == Judgement::worse);
  CHECK(judged("p99_mm", [](M& m) { m.deviation->p99_mm += 0.00011; }) == Judgement::worse);
  CHECK(judged("p01_mm", [](M& m) { m.deviation->p01_mm = 0.0001; }) == Judgement::same);
  CHECK(judged("p01_mm", [](M& m) { m.deviation->p01_mm = -0.00011; }) == Judgement::worse);
  CHECK(judged("mean_mm", [](M& m) { m.deviation->mean_mm += 1; }) == Judgement::not_judged);
  CHECK(judged("coverage", [](M& m) { m.deviation->coverage = 0.9982; }) == Judgement::same);
  CHECK(judged("coverage", [](M& m) { m.deviation->coverage = 0.9979; }) == Judgement::worse);
  CHECK(judged("voxel_uncut_mm", [](M& m) { m.deviation->voxel_uncut_mm = 0.09; }) ==
        Judgement::same);
  CHECK(judged("voxel_uncut_mm", [](M& m) { m.deviation->voxel_uncut_mm = 0.11; }) ==
        Judgement::worse);
  CHECK(judged("seconds", [](M& m) { m.seconds = 1e6; }) == Judgement::not_judged);
  CHECK(judged("machining_time_s", [](M& m) { m.machining_time_s = 900; }) ==
        Judgement::not_judged);
  const auto timed = [](double time_s) {
    RunRecord now = sample_run();
    now.stages[0].measures->machining_time_s = time_s;
    return figure(compare_runs(sample_run(), now, {10.0, {}, {}}), "machining_time_s").judgement;
  };
  CHECK(timed(109) == Judgement::same);
  CHECK(timed(111) == Judgement::worse);
  CHECK(timed(99.95) == Judgement::same);
  CHECK(timed(99) == Judgement::better);
}

TEST_CASE("What is not asked for is shown and not judged", "[unit][compare]") {
  const RunRecord worse = with_uncut({0.008, 0.009}, 0.008);
  CHECK(compare_runs(sample_run(), worse, {{}, {}, {"uncut_mm"}}).judgement() == Judgement::same);
  CHECK(compare_runs(sample_run(), worse, {{}, {"gouge_mm"}, {}}).judgement() == Judgement::same);
  CHECK(compare_runs(sample_run(), worse, {{}, {"uncut_mm"}, {}}).worse == 1);
}

TEST_CASE("Results of two schemas are not held against each other", "[unit][compare]") {
  RunRecord old = sample_run();
  old.schema = 1;
  CHECK(compare_runs(old, old, {}).judgement() == Judgement::same);
  for (const auto& [base, now] : {std::pair(old, sample_run()), std::pair(sample_run(), old)}) {
    try {
      compare_runs(base, now, {});
      FAIL("they were compared");
    } catch (const model::InputError& error) {
      CHECK_THAT(error.what(), ContainsSubstring("gouge and uncut do not mean the same"));
      CHECK_THAT(error.what(), ContainsSubstring("again with this limitgauge"));
    }
  }
}

TEST_CASE("What is out of reach is told in every comparison", "[unit][compare]") {
  RunRecord base = sample_run(), now = sample_run();
  now.stages[0].measures->deviation->reach = {95, 4, 1};
  now.stages[0].measures->deviation->unavoidable_mm = {0.1, 0.25};
  const std::string said =
      "unreachable: 4.00 mm² (4.00 %), unavoidable uncut up to 0.250 mm; before: nothing";
  const Comparison comparison = compare_runs(base, now, {});
  REQUIRE(comparison.stages[0].remarks.size() == 1);
  CHECK(comparison.stages[0].remarks[0].text == said);
  CHECK_THAT(text_table(comparison, false, 100, false), ContainsSubstring(said));
  CHECK_THAT(text_of(write_markdown, comparison), ContainsSubstring("unavoidable uncut up to"));
  CHECK(compare_runs(now, now, {}).stages[0].remarks.size() == 1);
}

TEST_CASE("Stock that is newly missing is a regression", "[unit][compare]") {
  RunRecord now = sample_run();
  now.stages[0].measures->deviation->missing_stock = {place_at(3, 0.05, 0)};
  const Comparison comparison = compare_runs(sample_run(), now, {});
  REQUIRE(comparison.stages[0].findings.size() == 1);
  CHECK(comparison.stages[0].findings[0].judgement == Judgement::worse);
  CHECK_THAT(text_table(comparison, false, 100, false), ContainsSubstring("new missing stock"));
}

TEST_CASE("Inputs and settings that differ are named", "[unit][compare]") {
  RunRecord now = sample_run();
  now.job = "another";
  now.inputs[0].file = "/elsewhere/part.toml";
  now.inputs[1].sha256 = "cc";
  now.stages[0].tool = "ball1";
  now.stages[0].measures->deviation->resolution_mm = 0.002;
  now.stages[0].measures->deviation->reached_resolution = false;
  const Comparison comparison = compare_runs(sample_run(), now, {});
  CHECK(comparison.judgement() == Judgement::same);
  REQUIRE(comparison.remarks.size() == 2);
  CHECK(comparison.remarks[0].text == "these are results of two jobs: part and another");
  CHECK(comparison.remarks[1].text ==
        "cage part.obj was changed: the figures are those of another surface");
  REQUIRE(comparison.stages[0].remarks.size() == 3);
  CHECK(comparison.stages[0].remarks[0].text == "tool was ball3, is ball1");
  CHECK(comparison.stages[0].remarks[1].text == "resolution was 1 µm, is 2 µm");
  CHECK(comparison.stages[0].remarks[2].text == "resolution was not reached (new run)");
}

TEST_CASE("Findings are matched by place and say what became of them", "[unit][compare]") {
  RunRecord base = sample_run(), now = sample_run();
  base.stages[0].measures->deviation->uncuts = {
      place_at(0, 0.02, 10), place_at(10, 0.02, 11), place_at(20, 0.02, 12), place_at(30, 0.02, 13),
      place_at(50, 0.004, 15)};  // the certificate's witness
  now.stages[0].measures->deviation->uncuts = {place_at(0.05, 0.0205, 10), place_at(10.5, 0.03, 21),
                                               place_at(20.5, 0.02, 22), place_at(40, 0.02, 24),
                                               place_at(60, 0.004, 25)};
  const StageComparison stage = compare_runs(base, now, {}).stages[0];
  CHECK(stage.same_findings == 1);
  REQUIRE(stage.findings.size() == 4);
  CHECK(stage.findings[0].status == FindingStatus::deeper);
  CHECK(stage.findings[0].now->line == 21U);
  CHECK(stage.findings[0].judgement == Judgement::worse);
  CHECK(stage.findings[1].status == FindingStatus::fresh);
  CHECK(stage.findings[1].judgement == Judgement::worse);
  CHECK(stage.findings[1].now->at_mm.x == 40);
  CHECK(stage.findings[2].status == FindingStatus::gone);
  CHECK(stage.findings[2].judgement == Judgement::better);
  CHECK(stage.findings[3].status == FindingStatus::moved);
  CHECK(stage.findings[3].judgement == Judgement::not_judged);
  // What the base run need not have listed, had it been there, is no regression of the list.
  base.stages[0].measures->deviation->findings_complete = false;
  CHECK(compare_runs(base, now, {}).stages[0].findings[1].judgement != Judgement::worse);
}

TEST_CASE("A new collision is a regression, a near miss is not", "[unit][compare]") {
  RunRecord now = sample_run();
  record::ProcessFinding hit{
      "rapid_through_stock", true, "cutter", "stock", 2, {1, 2, 3}, 0.5, 77, "G0 X1"};
  now.stages[0].measures->process_findings = {hit};
  const Comparison comparison = compare_runs(sample_run(), now, {});
  REQUIRE(comparison.stages[0].findings.size() == 1);
  CHECK(comparison.stages[0].findings[0].judgement == Judgement::worse);
  CHECK(text_table(comparison, false, 100, false)
            .find("new rapid through standing material 0.500 mm, line 77: G0 X1 at (1.000, 2.000, "
                  "3.000): worse") != std::string::npos);
  CHECK(compare_runs(sample_run(), now, {{}, {}, {"process"}}).worse == 0);
  now.stages[0].measures->process_findings[0].kind = "near_miss";
  now.stages[0].measures->process_findings[0].fails = false;
  CHECK(compare_runs(sample_run(), now, {}).worse == 0);
}

TEST_CASE("Runs are named by their labels, or by the folders that tell them apart",
          "[unit][compare]") {
  const auto names = [](record::RunRecord base, const char* base_file, record::RunRecord now,
                        const char* now_file) {
    Comparison comparison = compare_runs(base, now, {});
    name_runs(comparison, base, base_file, now, now_file);
    return comparison.base.name + " | " + comparison.now.name;
  };
  const record::RunRecord run = sample_run();
  CHECK(names(run, "out/old/result.json", run, "out/new/result.json") == "old | new");
  CHECK(names(run, "a/out", run, "b/out/") == "a/out | b/out");
  CHECK(names(run, "a/out", run, "a/out") == "out | out");
  CHECK(names(run, "baseline.json", run, "./out/result.json") == "baseline.json | out");
  record::RunRecord labelled = run;
  labelled.label = "before the new cutter";
  CHECK(names(labelled, "a", run, "b") == "before the new cutter | b");
  record::RunRecord now = run;
  now.stages[0].measures->deviation->gouge_mm.high += 1;
  Comparison comparison = compare_runs(labelled, now, {});
  name_runs(comparison, labelled, "a", now, "b");
  std::ostringstream page, comment;
  write_html(comparison, page);
  write_markdown(comparison, comment);
  CHECK(page.str().find("Base, before the new cutter") != std::string::npos);
  CHECK(comment.str().find("| base, before the new cutter | new, b |") != std::string::npos);
  CHECK(text_table(comparison, false, 100, false)
            .starts_with("base: before the new cutter; new: b\n"));
}

TEST_CASE("Places are paired one to one, nearest first", "[unit][compare]") {
  const std::vector<Spot> base = {{{0, 0, 0}, 2}, {{1, 0, 0}, 2}, {{9, 0, 0}, 1}};
  const std::vector<Spot> now = {{{0.9, 0, 0}, 2}, {{0.8, 0, 0}, 2}, {{10.5, 0, 0}, 1}};
  const std::vector<Match> matches = match_spots(base, now);
  REQUIRE(matches.size() == 2);
  CHECK(matches[0].base == 1);
  CHECK(matches[0].now == 0);
  CHECK(matches[1].base == 0);
  CHECK(matches[1].now == 1);
}

TEST_CASE("A hundred thousand places are paired in a moment", "[unit][compare][slow]") {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> at(0, 1000), shift(-0.01, 0.01);
  std::vector<Spot> base(100'000), now;
  for (Spot& spot : base) spot = {{at(random), at(random), 0}, 0.5};
  for (const Spot& spot : base)
    now.push_back({{spot.at_mm.x + shift(random), spot.at_mm.y + shift(random), 0}, 0.5});
  CHECK(match_spots(base, now).size() > 99'900);
  // All of the base at one distance from all of the new ones: nothing can be told apart.
  for (std::size_t i = 0; i < 20'000; ++i) {
    const double angle = 1e-3 * static_cast<double>(i);
    base[i] = {{std::cos(angle), std::sin(angle), 0}, 2};
    now[i] = {{0, 0, 0}, 2};
  }
  base.resize(20'000);
  now.resize(20'000);
  CHECK(match_spots(base, now).size() <= 20'000);
}

TEST_CASE("Texts of strangers are shown letter by letter", "[unit][compare]") {
  RunRecord base = sample_run(), now = with_uncut({0.02, 0.021}, 0.02);
  const std::string hostile = "<b>|@all [x](javascript:1) `*_#\n![](h)";
  for (RunRecord* run : {&base, &now}) {
    run->job = hostile;
    run->stages[0].name = hostile;
    run->stages[0].measures->deviation->uncuts = {place_at(1, 0.0205, 3)};
    run->stages[0].measures->deviation->uncuts[0].line_text = hostile;
  }
  now.stages[0].measures->deviation->uncuts[0].depth_mm = 0.05;
  now.stages[0].tool = hostile;
  now.inputs[0].file = hostile;
  now.inputs.push_back({hostile, hostile, "dd"});
  const Comparison comparison = compare_runs(base, now, {});
  const std::string page = text_of(write_html, comparison);
  CHECK(page.find("<b>") == std::string::npos);
  CHECK(page.find("<script") == std::string::npos);
  CHECK(page.find("default-src 'none'") != std::string::npos);
  const std::string markdown = text_of(write_markdown, comparison);
  for (const char* sign : {"<b", "@all", "[x]", "javascript:", "![", "`"}) {
    INFO(sign << " in\n" << markdown);
    CHECK(markdown.find(sign) == std::string::npos);
  }
  const auto json = nlohmann::json::parse(text_of(write_json, comparison));
  CHECK(json["stages"][0]["name"] == hostile);
  CHECK(json["judgement"] == "worse");
}

TEST_CASE("The table keeps to the terminal's width", "[unit][compare]") {
  RunRecord now = with_uncut({0.008, 0.009}, 0.008);
  const Comparison comparison = compare_runs(sample_run(), now, {});
  const std::string wide = text_table(comparison, false, 120, false);
  CHECK(wide.find("finish  uncut           [5.0, 6.0] µm") != std::string::npos);
  CHECK(wide.find("comparison: worse: 1 regression\n") != std::string::npos);
  CHECK(wide.find("coverage") == std::string::npos);
  CHECK(text_table(comparison, false, 120, true).find("coverage") != std::string::npos);
  CHECK(text_table(comparison, true, 120, false).find("\x1b[1;31mworse\x1b[0m") !=
        std::string::npos);
  const std::string narrow = text_table(comparison, false, 60, false);
  CHECK(narrow.find("floor") == std::string::npos);
  CHECK(narrow.find("worse") != std::string::npos);
}
