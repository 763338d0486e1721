#include <algorithm>

#include "reports/compare/run_comparison.h"
#include "reports/history/job_history.h"
#include "reports/history/run_entry.h"
#include "tests/reports/compare/compare_support.h"
#include "tests/support/catch.h"

/// What runs over tolerances say against each other, two at a time and along a history.
namespace limitgauge::reports {
namespace {

using compare::Comparison;
using compare::Judgement;
using history_report::Cell;
using history_report::JobHistory;
using record::RunRecord;
using verifier::Interval;

/// A run over a radius known to ± `radius_mm`, proven up to `margin` times that.
RunRecord tolerant_run(double radius_mm, double margin) {
  RunRecord run = compare::sample_run();
  run.tolerances.emplace().tools["ball3"].radius_mm = {-radius_mm, radius_mm};
  record::RobustMeasures& robust = run.stages[0].measures->deviation->robust.emplace();
  robust.gouge_mm = {0.002, 0.003};
  robust.uncut_mm = {0.007, 0.008};
  robust.margin = verifier::ToleranceMargin{margin, margin * 1.0005};
  return run;
}

RunRecord with_uncut(RunRecord run, const Interval& uncut_mm) {
  run.stages[0].measures->deviation->robust->uncut_mm = uncut_mm;
  return run;
}

Judgement compared(const std::string& id, const RunRecord& base, const RunRecord& now) {
  return compare::judgement_of(id, base, now);
}

const compare::Remark* tolerance_remark(const Comparison& comparison) {
  for (const compare::Remark& remark : comparison.remarks)
    if (remark.id == "tolerances") return &remark;
  return nullptr;
}

/// What the last of the runs says of a figure of the finish, read back as `--stage` and `--metric`
/// ask for it.
Cell last_cell(const std::vector<RunRecord>& runs, const std::string& metric,
               const history_report::Choice& choice = {}) {
  std::vector<history::Entry> entries;
  std::vector<history::Series> series;
  for (const RunRecord& run : runs) {
    entries.push_back(history_report::entry_of(run));
    for (const history::Value& one : entries.back().values)
      series.push_back({one.stage, one.metric});
  }
  const std::vector<std::string> read = history_report::metrics_to_read(choice, series);
  for (history::Entry& entry : entries)
    std::erase_if(entry.values, [&](const history::Value& one) {
      return std::find(read.begin(), read.end(), one.metric) == read.end();
    });
  const JobHistory job = history_report::job_histories(entries, choice).at(0);
  for (std::size_t i = 0; i < job.columns.size(); ++i)
    if (job.columns[i].stage == "finish" && job.columns[i].metric == metric)
      return job.runs.back().cells[i];
  throw std::runtime_error("no column " + metric);
}

}  // namespace

TEST_CASE("A margin that shrank is worse, one that grew is better", "[unit][compare][history]") {
  const RunRecord wide = tolerant_run(0.01, 3), narrow = tolerant_run(0.01, 2);
  CHECK(compared("margin", wide, narrow) == Judgement::worse);
  CHECK(compared("margin", narrow, wide) == Judgement::better);
  CHECK(compared("margin", wide, wide) == Judgement::same);
  CHECK(compare::compare_runs(wide, narrow, {}).judgement() == Judgement::worse);
  CHECK(compare::compare_runs(wide, wide, {}).judgement() == Judgement::same);
  CHECK(last_cell({wide, narrow}, "margin").judgement == Judgement::worse);
  CHECK(last_cell({narrow, wide}, "margin").judgement == Judgement::better);
  CHECK(last_cell({wide, wide}, "margin").judgement == Judgement::same);
  CHECK(last_cell({wide, narrow}, "margin").direction == -1);
}

TEST_CASE("Figures over the same tolerances are judged as certified ones",
          "[unit][compare][history]") {
  const RunRecord base = tolerant_run(0.01, 3), more = with_uncut(base, {0.010, 0.011});
  CHECK(compared("robust_uncut_mm", base, more) == Judgement::worse);
  CHECK(compared("robust_uncut_mm", more, base) == Judgement::better);
  CHECK(last_cell({base, more}, "robust_uncut_mm").judgement == Judgement::worse);
  CHECK(last_cell({more, base}, "robust_uncut_mm").judgement == Judgement::better);
  CHECK(last_cell({base, base}, "robust_uncut_mm").judgement == Judgement::same);
}

TEST_CASE("Over other tolerances, neither better nor worse is said", "[unit][compare][history]") {
  const RunRecord base = tolerant_run(0.01, 3);
  const RunRecord other = with_uncut(tolerant_run(0.02, 1.5), {0.010, 0.011});
  for (const char* id : {"margin", "robust_uncut_mm", "robust_gouge_mm"}) {
    CAPTURE(id);
    for (const auto& [from, to] : {std::pair(base, other), std::pair(other, base)}) {
      CHECK(compared(id, from, to) == Judgement::not_judged);
      CHECK_FALSE(last_cell({from, to}, id).judgement);
      // As `history --stage finish --metric ID` reads it: the tolerances come along.
      CHECK_FALSE(last_cell({from, to}, id, {{"finish"}, {id}}).judgement);
    }
  }
  REQUIRE(tolerance_remark(compare::compare_runs(base, other, {})));
  CHECK(tolerance_remark(compare::compare_runs(base, other, {}))->text.find("widened") !=
        std::string::npos);
  CHECK_FALSE(tolerance_remark(compare::compare_runs(base, base, {})));
  // What is stated was measured alike in both.
  CHECK(compared("uncut_mm", base, other) == Judgement::same);
  CHECK(last_cell({base, other}, "uncut_mm").judgement == Judgement::same);
  // A zero that one of them states is another box, too.
  RunRecord shifted = base;
  shifted.tolerances->zero_mm[2] = {-0.005, 0.005};
  CHECK_FALSE(last_cell({base, shifted}, "margin").judgement);
  CHECK(compared("margin", base, shifted) == Judgement::not_judged);
}

TEST_CASE("A margin of another limit is another question", "[unit][compare][history]") {
  const RunRecord base = tolerant_run(0.01, 3);
  RunRecord loose = tolerant_run(0.01, 5);
  loose.stages[0].limits.uncut_mm = 0.02;
  CHECK(compared("margin", base, loose) == Judgement::not_judged);
  CHECK(compared("robust_uncut_mm", base, loose) == Judgement::same);
  CHECK_FALSE(last_cell({base, loose}, "margin").judgement);
  CHECK(last_cell({base, loose}, "robust_uncut_mm").judgement == Judgement::same);
}

TEST_CASE("The place that fails over tolerances is named though none does as stated",
          "[unit][compare]") {
  const auto with_place = [](RunRecord run, double depth_mm) {
    run = with_uncut(std::move(run), {depth_mm, depth_mm + 0.001});
    run.stages[0].measures->deviation->robust->uncut = compare::place_at(7, depth_mm, 12);
    return run;
  };
  const RunRecord good = with_place(tolerant_run(0.01, 3), 0.008);
  const RunRecord bad = with_place(tolerant_run(0.01, 3), 0.015);
  const Comparison worse = compare::compare_runs(good, bad, {}),
                   better = compare::compare_runs(bad, good, {});
  REQUIRE(worse.stages[0].findings.size() == 1);
  const compare::FindingChange& change = worse.stages[0].findings[0];
  CHECK(change.kind == "robust_uncut");
  CHECK(change.status == compare::FindingStatus::fresh);
  CHECK(change.judgement == Judgement::worse);
  CHECK(change.now->line == 12);
  CHECK(better.stages[0].findings.at(0).judgement == Judgement::better);
  CHECK(compare::figure(worse, "robust_uncut_mm").where->line == 12);
  CHECK(compare::compare_runs(bad, bad, {}).stages[0].findings.empty());
  // Over other tolerances the two places are not held against each other.
  const RunRecord other = with_place(tolerant_run(0.02, 3), 0.015);
  CHECK(compare::compare_runs(good, other, {}).stages[0].findings.empty());
}

TEST_CASE("Tolerances that one run alone has", "[unit][compare][history]") {
  const RunRecord with = tolerant_run(0.01, 3), without = compare::sample_run();
  const Comparison lost = compare::compare_runs(with, without, {}),
                   set = compare::compare_runs(without, with, {});
  REQUIRE(tolerance_remark(lost));
  CHECK(tolerance_remark(lost)->judgement == Judgement::worse);
  CHECK(tolerance_remark(set)->judgement == Judgement::better);
  for (const compare::FigureChange& change : lost.stages[0].figures)
    CHECK_FALSE(record::is_over_tolerances(change.metric->id));
  // A run without between two with the same ones does not come between them.
  CHECK(last_cell({with, without, tolerant_run(0.01, 2)}, "margin").judgement == Judgement::worse);
  CHECK_FALSE(last_cell({with, without, tolerant_run(0.02, 2)}, "margin").judgement);
  CHECK_FALSE(last_cell({with, without}, "margin").value);
}

}  // namespace limitgauge::reports
