#include <algorithm>

#include "reports/compare/comparison_text.h"
#include "reports/compare/report.h"
#include "reports/junit/test_report.h"
#include "reports/text/text.h"

namespace limitgauge::reports::compare {
namespace {

using junit::Case;
using junit::Outcome;

/// A case that has failed where anything in it got worse.
Case judged_case(std::string what, bool is_worse, std::string message, std::string body = {}) {
  if (is_worse)
    return {std::move(what), Outcome::failure, "regression", std::move(message), std::move(body)};
  return {std::move(what), Outcome::passed, {}, std::move(message)};
}

/// "uncut 5 µm, now 7 µm (+2 µm, floor 1 µm): worse: the new interval lies above the old one".
std::string change_words(const FigureChange& figure) {
  const FigureText text = figure_text(figure);
  std::string words = std::string(figure.metric->label) + " " + text.base + ", now " + text.now;
  if (!text.change.empty())
    words += " (" + text.change + (text.floor.empty() ? "" : ", floor " + text.floor) + ")";
  words += std::string(": ") + name(figure.judgement);
  return figure.why.empty() ? words : words + ": " + figure.why;
}

std::string spot_words(const FoundPlace& place, const std::string& stage) {
  return line_text(place, stage) + at_text(place) + " mm";
}

/// What can be judged and is not is skipped, so that nobody takes it for good; what neither way is
/// better of, and what a run took of the machine, is no case.
void add_figures(std::vector<Case>& cases, const StageComparison& stage, const Options& options) {
  const std::vector<std::string_view> known = judged_ids();
  for (const FigureChange& figure : stage.figures) {
    if (std::find(known.begin(), known.end(), figure.metric->id) == known.end()) continue;
    const std::string what(figure.metric->label), words = change_words(figure);
    if (figure.judgement == Judgement::not_judged) {
      const bool chosen = is_judged(options, figure.metric->id);
      cases.push_back({what, Outcome::skipped, {}, chosen ? words : "not asked for: " + words});
      continue;
    }
    const std::string where = figure.where ? "deepest " + measured_length(figure.where->depth_mm) +
                                                 ", " + spot_words(*figure.where, stage.name)
                                           : std::string{};
    cases.push_back(judged_case(what, figure.judgement == Judgement::worse, words, where));
  }
}

/// A case for each kind of remark that is judged, by the first that is worse, and all of them below
/// it.
void add_remarks(std::vector<Case>& cases, const std::vector<Remark>& remarks) {
  std::vector<std::string> kinds;
  for (const Remark& remark : remarks)
    if (remark.judgement != Judgement::not_judged &&
        std::find(kinds.begin(), kinds.end(), remark.id) == kinds.end())
      kinds.push_back(remark.id);
  for (const std::string& kind : kinds) {
    const Remark* first = nullptr;
    std::vector<std::string> all;
    for (const Remark& remark : remarks) {
      if (remark.id != kind || remark.judgement == Judgement::not_judged) continue;
      all.push_back(remark.text + ": " + name(remark.judgement));
      const bool is_first_worse =
          remark.judgement == Judgement::worse && first && first->judgement != Judgement::worse;
      if (!first || is_first_worse) first = &remark;
    }
    cases.push_back(
        judged_case(kind, first->judgement == Judgement::worse, first->text, joined(all, "\n")));
  }
}

/// Of a verdict that has not changed nothing is remarked.
void add_verdict(std::vector<Case>& cases, verifier::Verdict verdict) {
  const auto is_verdict = [](const Case& c) { return c.name == "verdict"; };
  if (std::none_of(cases.begin(), cases.end(), is_verdict))
    cases.insert(cases.begin(), judged_case("verdict", false,
                                            std::string(verifier::name(verdict)) + ", as before"));
}

void add_findings(std::vector<Case>& cases, const StageComparison& stage) {
  std::vector<std::string> worse;
  for (const FindingChange& change : stage.findings)
    if (change.judgement == Judgement::worse)
      worse.push_back(std::string(name(change)) + " " + kind_text(change.kind) + " " +
                      depth_text(change) + ", " +
                      spot_words(change.now ? *change.now : *change.base, stage.name));
  const std::string message =
      worse.empty() ? "none is worse, " + grouped(stage.same_findings) + " the same"
                    : worse.front() +
                          (worse.size() == 1 ? "" : ", and " + grouped(worse.size() - 1) + " more");
  cases.push_back(judged_case("findings", !worse.empty(), message, joined(worse, "\n")));
}

junit::Suite run_suite(const Comparison& comparison) {
  const auto version = [](const RunHead& head) { return head.version + ", " + head.created; };
  junit::Suite suite{comparison.now.job,
                     "limitgauge.compare",
                     {{"base", version(comparison.base)},
                      {"new", version(comparison.now)},
                      {"judgement", summary(comparison)}},
                     {},
                     0,
                     comparison.now.created};
  add_remarks(suite.cases, comparison.remarks);
  add_verdict(suite.cases, comparison.now.verdict);
  return suite;
}

junit::Suite stage_suite(const StageComparison& stage, const Comparison& comparison) {
  junit::Suite suite{
      stage.name, "limitgauge.compare." + stage.name, {}, {}, 0, comparison.now.created};
  add_remarks(suite.cases, stage.remarks);
  if (!stage.base) suite.cases.push_back({"stage", Outcome::skipped, {}, "not in the base run"});
  if (!stage.base || !stage.now) return suite;
  add_verdict(suite.cases, *stage.now);
  add_figures(suite.cases, stage, comparison.options);
  add_findings(suite.cases, stage);
  return suite;
}

}  // namespace

void write_junit(const Comparison& comparison, std::ostream& out) {
  junit::TestReport report{comparison.now.job + ", compared", {run_suite(comparison)}, 0};
  for (const StageComparison& stage : comparison.stages)
    report.suites.push_back(stage_suite(stage, comparison));
  junit::write(report, out);
}

}  // namespace limitgauge::reports::compare
