#include <algorithm>

#include "model/text/number_text.h"
#include "reports/junit/test_report.h"
#include "reports/run/finding_list.h"
#include "reports/run/gate_figures.h"
#include "reports/run/process.h"
#include "reports/run/report.h"
#include "reports/text/text.h"

namespace limitgauge::reports {
namespace {

using junit::Case;
using junit::Outcome;

/// What the cases of one stage are made of.
struct Measured {
  const RunResult& result;
  const StageResult& stage;
  std::vector<ListedFinding> findings;
};

/// Whether a finding counts for a figure of the gate.
bool counts_for(const ListedFinding& f, const std::string& figure) {
  if (!f.process)
    return f.kind == figure || (f.kind == "missing_stock" && figure == "missing stock");
  const simulator::FindingKind kind = f.process->kind;
  if (figure == "rapid collisions") return kind == simulator::FindingKind::rapid_through_stock;
  if (figure == "holder collisions") return is_holder_collision(kind);
  return figure == "process faults" && fails(kind) && !is_holder_collision(kind) &&
         kind != simulator::FindingKind::rapid_through_stock;
}

/// The first that counts is the worst.
std::string worst_place(const Measured& m, const std::string& figure) {
  const auto worst = std::find_if(m.findings.begin(), m.findings.end(),
                                  [&](const ListedFinding& f) { return counts_for(f, figure); });
  if (worst == m.findings.end()) return {};
  const model::Vec3& p = worst->point;
  std::string text = "; worst " + worst->id + " (" + worst->words + ") " +
                     measured_length(worst->depth_mm) + " at (" + fixed(p.x, 3) + ", " +
                     fixed(p.y, 3) + ", " + fixed(p.z, 3) + ") mm";
  if (worst->place) text += ", patch " + std::to_string(worst->place->patch);
  if (worst->line == 0) return text;
  return text + ", line " + std::to_string(worst->line) + " of " +
         program_file(m.result.stages[worst->program_stage]);
}

std::string message_for(const GateFigure& figure, const Measured& m) {
  std::string text = figure.name + " " + figure.measured;
  if (!figure.limit.empty()) text += ", limit " + figure.limit;
  return text + worst_place(m, figure.name);
}

/// One measurement gives several figures: its time stands at the first of them.
double seconds_of(const std::string& figure, const StageResult& stage) {
  if (!stage.ran) return 0;
  if (figure == "gouge" && stage.ran->deviation) return stage.ran->deviation->seconds;
  return figure == "rapid collisions" ? stage.ran->simulation_seconds : 0;
}

Case case_of(const GateFigure& figure, const Measured& m) {
  const std::string said = message_for(figure, m);
  const std::string reasons = joined(m.stage.decision.reasons, "\n");
  const double seconds = seconds_of(figure.name, m.stage);
  switch (figure.standing) {
    case Standing::within:
      return {figure.name, Outcome::passed, {}, said, {}, seconds};
    case Standing::beyond:
      return {figure.name, Outcome::failure, "beyond the limit", said, reasons, seconds};
    case Standing::undecided:
      return {figure.name, Outcome::error, "indeterminate", said, reasons, seconds};
    case Standing::no_limit:
      return {figure.name, Outcome::skipped, {}, "no limit stated: " + said, {}, seconds};
    case Standing::not_run:
      break;
  }
  return {figure.name, Outcome::skipped, {}, "not run", reasons, seconds};
}

bool has(const std::vector<Case>& cases, Outcome outcome) {
  return std::any_of(cases.begin(), cases.end(),
                     [=](const Case& c) { return c.outcome == outcome; });
}

/// A verdict that no single figure explains must not vanish from CI.
void add_verdict(std::vector<Case>& cases, const StageResult& stage) {
  const verifier::Verdict verdict = stage.decision.verdict;
  const bool fails = verdict == verifier::Verdict::fail && !has(cases, Outcome::failure);
  const bool undecided = verdict == verifier::Verdict::indeterminate &&
                         !has(cases, Outcome::failure) && !has(cases, Outcome::error);
  if (!fails && !undecided) return;
  cases.push_back({"verdict", fails ? Outcome::failure : Outcome::error,
                   fails ? "beyond the limit" : "indeterminate", verifier::name(verdict),
                   joined(stage.decision.reasons, "\n")});
}

/// What the stage was asked for, and where its program is.
std::vector<junit::Property> properties_of(const StageResult& stage, const RunResult& result) {
  std::vector<junit::Property> list = {{"version", result.version},
                                       {"verdict", verifier::name(stage.verdict())},
                                       {"tool", stage.tool},
                                       {"cutter", model::to_text(stage.cutter)}};
  if (!stage.strategy.empty()) list.push_back({"strategy", stage.strategy});
  list.push_back({"program", program_file(stage)});
  if (stage.allowance_mm) list.push_back({"allowance_mm", model::shortest(*stage.allowance_mm)});
  return list;
}

junit::Suite suite_of(const RunResult& result, std::size_t index) {
  const Measured from{result, result.stages[index], list_findings(result, index)};
  const StageResult& stage = from.stage;
  junit::Suite suite{
      stage.name,    "limitgauge." + stage.name, properties_of(stage, result), {}, stage.seconds,
      result.created};
  for (const GateFigure& figure : gate_figures(stage)) suite.cases.push_back(case_of(figure, from));
  if (stage.ran) add_verdict(suite.cases, stage);
  return suite;
}

}  // namespace

void write_junit(const RunResult& result, std::ostream& out) {
  junit::TestReport report{result.job, {}, result.surface ? result.surface->seconds : 0};
  for (std::size_t i = 0; i < result.stages.size(); ++i) {
    report.suites.push_back(suite_of(result, i));
    report.seconds += result.stages[i].seconds;
  }
  junit::write(report, out);
}

}  // namespace limitgauge::reports
