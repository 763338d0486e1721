#include <algorithm>
#include <pugixml.hpp>

#include "model/text/number_text.h"
#include "reports/run/finding_list.h"
#include "reports/run/gate_figures.h"
#include "reports/run/process.h"
#include "reports/run/report.h"
#include "reports/text/text.h"

namespace limitgauge::reports {
namespace {

struct Counts {
  int tests = 0, failures = 0, errors = 0, skipped = 0;
  Counts& operator+=(const Counts& b) {
    tests += b.tests, failures += b.failures, errors += b.errors, skipped += b.skipped;
    return *this;
  }
};

void set(pugi::xml_node node, const char* key, const std::string& value) {
  node.append_attribute(key).set_value(clean_text(value).c_str());
}

void set_counts(pugi::xml_node node, const Counts& counts) {
  node.append_attribute("tests").set_value(counts.tests);
  node.append_attribute("failures").set_value(counts.failures);
  node.append_attribute("errors").set_value(counts.errors);
  node.append_attribute("skipped").set_value(counts.skipped);
}

std::string clean_lines(std::vector<std::string> lines) {
  for (std::string& line : lines) line = clean_text(line);
  return joined(lines, "\n");
}

void add_outcome(pugi::xml_node test, const char* element, const char* type,
                 const std::string& message, const std::string& body) {
  pugi::xml_node node = test.append_child(element);
  set(node, "message", message);
  if (type) set(node, "type", type);
  if (!body.empty()) node.text().set(clean_text(body).c_str());
}

/// What the cases of one stage are made of.
struct Suite {
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
std::string worst_place(const Suite& suite, const std::string& figure) {
  const auto worst = std::find_if(suite.findings.begin(), suite.findings.end(),
                                  [&](const ListedFinding& f) { return counts_for(f, figure); });
  if (worst == suite.findings.end()) return {};
  const model::Vec3& p = worst->point;
  std::string text = "; worst " + worst->id + " (" + worst->words + ") " +
                     measured_length(worst->depth_mm) + " at (" + fixed(p.x, 3) + ", " +
                     fixed(p.y, 3) + ", " + fixed(p.z, 3) + ") mm";
  if (worst->place) text += ", patch " + std::to_string(worst->place->patch);
  if (worst->line == 0) return text;
  return text + ", line " + std::to_string(worst->line) + " of " +
         program_file(suite.result.stages[worst->program_stage]);
}

std::string message_for(const GateFigure& figure, const Suite& suite) {
  std::string text = figure.name + " " + figure.measured;
  if (!figure.limit.empty()) text += ", limit " + figure.limit;
  return clean_text(text + worst_place(suite, figure.name));
}

/// One measurement gives several figures: its time stands at the first of them.
double seconds_of(const std::string& figure, const StageResult& stage) {
  if (!stage.ran) return 0;
  if (figure == "gouge" && stage.ran->deviation) return stage.ran->deviation->seconds;
  return figure == "rapid collisions" ? stage.ran->simulation_seconds : 0;
}

void add_figure(pugi::xml_node test, const GateFigure& figure, const Suite& suite, Counts& counts) {
  const std::string reasons = clean_lines(suite.stage.decision.reasons);
  switch (figure.standing) {
    case Standing::within:
      test.append_child("system-out").text().set(message_for(figure, suite).c_str());
      break;
    case Standing::beyond:
      ++counts.failures;
      add_outcome(test, "failure", "beyond the limit", message_for(figure, suite), reasons);
      break;
    case Standing::undecided:
      ++counts.errors;
      add_outcome(test, "error", "indeterminate", message_for(figure, suite), reasons);
      break;
    case Standing::no_limit:
      ++counts.skipped;
      add_outcome(test, "skipped", nullptr, "no limit stated: " + message_for(figure, suite), {});
      break;
    case Standing::not_run:
      ++counts.skipped;
      add_outcome(test, "skipped", nullptr, "not run", reasons);
      break;
  }
}

pugi::xml_node add_case(pugi::xml_node suite, const std::string& stage, const std::string& what,
                        double seconds) {
  pugi::xml_node test = suite.append_child("testcase");
  set(test, "classname", "limitgauge." + stage);
  set(test, "name", what);
  set(test, "time", fixed(seconds, 3));
  return test;
}

/// A verdict that no single figure explains must not vanish from CI.
void add_verdict(pugi::xml_node suite, const StageResult& stage, Counts& counts) {
  const verifier::Verdict verdict = stage.decision.verdict;
  const bool fails = verdict == verifier::Verdict::fail && counts.failures == 0;
  const bool undecided =
      verdict == verifier::Verdict::indeterminate && counts.failures + counts.errors == 0;
  if (!fails && !undecided) return;
  ++counts.tests;
  ++(fails ? counts.failures : counts.errors);
  add_outcome(add_case(suite, stage.name, "verdict", 0), fails ? "failure" : "error",
              fails ? "beyond the limit" : "indeterminate", verifier::name(verdict),
              clean_lines(stage.decision.reasons));
}

/// What the stage was asked for, and where its program is.
void add_properties(pugi::xml_node suite, const StageResult& stage, const RunResult& result) {
  pugi::xml_node list = suite.append_child("properties");
  const auto add = [&](const char* name, const std::string& value) {
    pugi::xml_node property = list.append_child("property");
    set(property, "name", name);
    set(property, "value", value);
  };
  add("version", result.version);
  add("verdict", verifier::name(stage.verdict()));
  add("tool", stage.tool);
  add("cutter", model::to_text(stage.cutter));
  if (!stage.strategy.empty()) add("strategy", stage.strategy);
  add("program", program_file(stage));
  if (stage.allowance_mm) add("allowance_mm", model::shortest(*stage.allowance_mm));
}

Counts add_suite(pugi::xml_node root, const RunResult& result, std::size_t index) {
  const Suite from{result, result.stages[index], list_findings(result, index)};
  const StageResult& stage = from.stage;
  pugi::xml_node suite = root.append_child("testsuite");
  set(suite, "name", stage.name);
  add_properties(suite, stage, result);
  Counts counts;
  for (const GateFigure& figure : gate_figures(stage)) {
    ++counts.tests;
    add_figure(add_case(suite, stage.name, figure.name, seconds_of(figure.name, stage)), figure,
               from, counts);
  }
  if (stage.ran) add_verdict(suite, stage, counts);
  set_counts(suite, counts);
  set(suite, "time", fixed(stage.seconds, 3));
  set(suite, "timestamp", result.created);
  return counts;
}

}  // namespace

void write_junit(const RunResult& result, std::ostream& out) {
  pugi::xml_document document;
  pugi::xml_node declaration = document.append_child(pugi::node_declaration);
  set(declaration, "version", "1.0");
  set(declaration, "encoding", "UTF-8");
  pugi::xml_node root = document.append_child("testsuites");
  set(root, "name", result.job);
  Counts all;
  double seconds = result.surface ? result.surface->seconds : 0;
  for (std::size_t i = 0; i < result.stages.size(); ++i) {
    all += add_suite(root, result, i);
    seconds += result.stages[i].seconds;
  }
  set_counts(root, all);
  set(root, "time", fixed(seconds, 3));
  document.save(out, "  ");
}

}  // namespace limitgauge::reports
