#include "tests/reports/hostile_result.h"

#include "tests/reports/sample_result.h"

namespace limitgauge::reports {
namespace {

/// Ends the script element, and the comment that a script element may hold.
const std::string kScript = "</script><img src=x onerror=window.hostile=1><!--<script>";
/// Ends an attribute of either quote, then an element of its own.
const std::string kAttribute = "\"'><svg onload=window.hostile=1>&lt;b&gt;";
const std::string kLink = "javascript:window.hostile=1//";

/// The program with a comment of markup on every line.
std::string hostile_program(const std::string& program) {
  std::string text;
  bool even = true;
  for (const char c : program) {
    if (c == '\n') text += even ? " (" + kScript + ")" : " (" + kAttribute + ")", even = !even;
    text += c;
  }
  return text;
}

void spoil_findings(std::vector<verifier::Finding>& findings) {
  for (verifier::Finding& f : findings) f.body += kAttribute;
}

void spoil_measured(StageRun& ran) {
  ran.program_text = std::make_shared<const std::string>(hostile_program(*ran.program_text));
  ran.ignored_words = {"7: " + kScript, "8: " + kAttribute};
  for (simulator::Finding& f : ran.process) f.part += kScript, f.against += kAttribute;
  spoil_findings(ran.deviation->gouges);
  spoil_findings(ran.deviation->uncuts);
  for (verifier::BodyFigure& b : ran.deviation->bodies) b.body += kScript;
  for (verifier::UncertaintyTerm& t : ran.deviation->budget) t.source += kAttribute;
}

void spoil_stage(StageResult& stage) {
  stage.name += kScript, stage.tool += kAttribute, stage.cutter.id += kScript;
  stage.strategy.clear();
  stage.program = kLink + kScript, stage.program_part = kAttribute;
  for (std::string& reason : stage.decision.reasons) reason += kScript;
  if (stage.ran) spoil_measured(*stage.ran);
}

}  // namespace

RunResult hostile_result() {
  RunResult r = sample_result(Outcome::failed);
  r.job = kScript + kAttribute;
  r.surface->cage = kLink + kAttribute + kScript;
  for (std::string& a : r.assumptions) a += kScript + kAttribute;
  for (StageResult& stage : r.stages) spoil_stage(stage);
  return r;
}

}  // namespace limitgauge::reports
