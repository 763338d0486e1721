#include <algorithm>
#include <pugixml.hpp>

#include "reports/gate_figures.h"
#include "reports/report.h"
#include "reports/text.h"

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

std::string joined(const std::vector<std::string>& lines) {
  std::string all;
  for (const std::string& line : lines) {
    if (!all.empty()) all += '\n';
    all += clean_text(line);
  }
  return all;
}

void add_outcome(pugi::xml_node test, const char* element, const char* type,
                 const std::string& message, const std::string& body) {
  pugi::xml_node node = test.append_child(element);
  set(node, "message", message);
  if (type) set(node, "type", type);
  if (!body.empty()) node.text().set(clean_text(body).c_str());
}

std::string worst_place(const std::vector<verifier::Finding>& findings) {
  if (findings.empty()) return {};
  const verifier::Finding& f = findings.front();
  const model::Vec3& p = f.place.point;
  return "; worst " + measured_length(f.depth_mm) + " at (" + fixed(p.x, 3) + ", " + fixed(p.y, 3) +
         ", " + fixed(p.z, 3) + ") mm, patch " + std::to_string(f.place.patch) + ", line " +
         std::to_string(f.line);
}

std::string message_for(const GateFigure& figure, const StageResult& stage) {
  std::string text = figure.name + " " + figure.measured;
  if (!figure.limit.empty()) text += ", limit " + figure.limit;
  if (figure.name == "gouge") text += worst_place(stage.ran->deviation.gouges);
  if (figure.name == "uncut") text += worst_place(stage.ran->deviation.uncuts);
  return text;
}

void add_figure(pugi::xml_node test, const GateFigure& figure, const StageResult& stage,
                Counts& counts) {
  const std::string reasons = joined(stage.decision.reasons);
  switch (figure.standing) {
    case Standing::within:
      test.append_child("system-out").text().set(message_for(figure, stage).c_str());
      break;
    case Standing::beyond:
      ++counts.failures;
      add_outcome(test, "failure", "beyond the limit", message_for(figure, stage), reasons);
      break;
    case Standing::undecided:
      ++counts.errors;
      add_outcome(test, "error", "indeterminate", message_for(figure, stage), reasons);
      break;
    case Standing::no_limit:
      ++counts.skipped;
      add_outcome(test, "skipped", nullptr, "no limit stated: " + message_for(figure, stage), {});
      break;
    case Standing::not_run:
      ++counts.skipped;
      add_outcome(test, "skipped", nullptr, "not run", reasons);
      break;
  }
}

pugi::xml_node add_case(pugi::xml_node suite, const std::string& stage, const std::string& what) {
  pugi::xml_node test = suite.append_child("testcase");
  set(test, "classname", "limitgauge." + stage);
  set(test, "name", what);
  set(test, "time", "0");
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
  add_outcome(add_case(suite, stage.name, "verdict"), fails ? "failure" : "error",
              fails ? "beyond the limit" : "indeterminate", verifier::name(verdict),
              joined(stage.decision.reasons));
}

Counts add_suite(pugi::xml_node root, const StageResult& stage, const std::string& created) {
  pugi::xml_node suite = root.append_child("testsuite");
  set(suite, "name", stage.name);
  Counts counts;
  for (const GateFigure& figure : gate_figures(stage)) {
    ++counts.tests;
    add_figure(add_case(suite, stage.name, figure.name), figure, stage, counts);
  }
  if (stage.ran) add_verdict(suite, stage, counts);
  set_counts(suite, counts);
  set(suite, "time", fixed(stage.seconds, 3));
  set(suite, "timestamp", created);
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
  double seconds = result.surface.seconds;
  for (const StageResult& stage : result.stages) {
    all += add_suite(root, stage, result.created);
    seconds += stage.seconds;
  }
  set_counts(root, all);
  set(root, "time", fixed(seconds, 3));
  document.save(out, "  ");
}

}  // namespace limitgauge::reports
