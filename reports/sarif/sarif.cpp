#include <algorithm>
#include <map>
#include <ostream>

#include "reports/run/gate_figures.h"
#include "reports/run/report.h"
#include "reports/sarif/fingerprint.h"
#include "reports/sarif/result_entry.h"
#include "reports/text/text.h"

namespace limitgauge::reports {
namespace {

using sarif::Json;
using verifier::Verdict;

constexpr const char* kSchema =
    "https://docs.oasis-open.org/sarif/sarif/v2.1.0/errata01/os/schemas/sarif-schema-2.1.0.json";

bool coverage_fails(const StageResult& stage) {
  return stage.limits.has_coverage && stage.ran->deviation &&
         stage.ran->deviation->coverage < stage.limits.coverage;
}

/// Of figures that no finding stands for.
const char* rule_of(const GateFigure& figure) {
  if (figure.name == "unreachable") return sarif::kUnreachableRule;
  return figure.name == "unavoidable uncut" ? sarif::kUnavoidableRule : nullptr;
}

/// A verdict that the findings do not explain must not vanish.
void add_unplaced(Json& results, const RunResult& result, std::size_t index,
                  const sarif::Places& places, bool has_error, bool has_warning) {
  const StageResult& stage = result.stages[index];
  if (coverage_fails(stage)) {
    has_error = true;
    results.push_back(sarif::stage_entry(result, index, sarif::kCoverageRule, "error",
                                         "coverage " +
                                             percent_text(stage.ran->deviation->coverage) +
                                             ", limit " + percent_text(stage.limits.coverage),
                                         places));
  }
  for (const GateFigure& figure : gate_figures(stage)) {
    const char* rule = rule_of(figure);
    const bool beyond = figure.standing == Standing::beyond;
    if (rule == nullptr || (!beyond && figure.standing != Standing::undecided)) continue;
    (beyond ? has_error : has_warning) = true;
    results.push_back(sarif::stage_entry(
        result, index, rule, beyond ? "error" : "warning",
        figure.name + " " + figure.measured +
            (figure.limit.empty() ? ": nothing is in reach" : ", limit " + figure.limit),
        places));
  }
  const bool fails = stage.verdict() == Verdict::fail && !has_error;
  const bool open = stage.verdict() == Verdict::indeterminate && !has_error && !has_warning;
  if (fails || open)
    results.push_back(sarif::stage_entry(result, index, sarif::kVerdictRule,
                                         fails ? "error" : "warning",
                                         joined(stage.decision.reasons, "; "), places));
}

Json results_of(const RunResult& result, const std::vector<std::vector<ListedFinding>>& findings,
                const sarif::Places& places) {
  Json results = Json::array();
  for (std::size_t i = 0; i < findings.size(); ++i) {
    if (!result.stages[i].ran) continue;
    const std::string stage = clean_text(result.stages[i].name);
    std::map<std::string, int> seen;
    for (const ListedFinding& f : findings[i])
      if (f.significance != Significance::within)
        results.push_back(
            sarif::result_entry(result, f, places, ++seen[sarif::place_fingerprint(f, stage)]));
    const auto has = [&](Significance significance) {
      return std::any_of(findings[i].begin(), findings[i].end(),
                         [=](const ListedFinding& f) { return f.significance == significance; });
    };
    add_unplaced(results, result, i, places, has(Significance::fails),
                 has(Significance::undecided));
  }
  return results;
}

/// The run came to its end; stages that had no turn are told.
Json invocation(const RunResult& result) {
  Json notes = Json::array();
  for (const StageResult& stage : result.stages)
    if (!stage.ran)
      notes.push_back(
          {{"level", "note"}, {"message", {{"text", clean_text(stage.name + ": not run")}}}});
  Json out = {{"executionSuccessful", true}};
  if (!notes.empty()) out["toolExecutionNotifications"] = std::move(notes);
  out["properties"] = {{"verdict", verifier::name(result.verdict)}};
  return out;
}

}  // namespace

void write_sarif(const RunResult& result, std::ostream& out) {
  std::vector<std::vector<ListedFinding>> findings;
  for (std::size_t i = 0; i < result.stages.size(); ++i)
    findings.push_back(list_findings(result, i));
  const sarif::Places places(result, findings);
  const Json driver = {
      {"name", "Limitgauge"}, {"version", clean_text(result.version)}, {"rules", sarif::rules()}};
  const Json run = {{"tool", {{"driver", driver}}},
                    {"automationDetails", {{"id", "limitgauge/" + clean_text(result.job) + "/"}}},
                    {"invocations", {invocation(result)}},
                    {"originalUriBaseIds", sarif::base_ids()},
                    {"artifacts", places.artifacts()},
                    {"results", results_of(result, findings, places)}};
  const Json root = {{"$schema", kSchema}, {"version", "2.1.0"}, {"runs", {run}}};
  out << root.dump(1) << '\n';
}

}  // namespace limitgauge::reports
