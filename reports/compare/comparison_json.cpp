#include <ostream>

#include "reports/compare/comparison_text.h"
#include "reports/compare/report.h"
#include "reports/json/values.h"
#include "reports/text/text.h"

namespace limitgauge::reports::compare {
namespace {

using json::Json;

const char* id(Judgement judgement) {
  return judgement == Judgement::not_judged ? "not_judged" : name(judgement);
}

Json head_part(const RunHead& head) {
  return {{"job", clean_text(head.job)},
          {"version", clean_text(head.version)},
          {"created", clean_text(head.created)},
          {"verdict", verifier::name(head.verdict)},
          {"machining_time_s", json::finite("machining_time_s", head.machining_time_s)}};
}

Json place_part(const FoundPlace& place) {
  Json out = {{"x", json::finite("place", place.at_mm.x)},
              {"y", json::finite("place", place.at_mm.y)},
              {"z", json::finite("place", place.at_mm.z)},
              {"depth_mm", json::finite("place", place.depth_mm)},
              {"stage", clean_text(place.stage)}};
  if (place.line) out["line"] = *place.line;
  if (!place.line_text.empty()) out["line_text"] = clean_text(place.line_text);
  if (!place.by.empty()) out["by"] = clean_text(place.by);
  return out;
}

Json figure_part(const FigureChange& figure) {
  Json out = {{"metric", figure.metric->id},
              {"source", record::name(figure.metric->source)},
              {"judgement", id(figure.judgement)},
              {"why", clean_text(figure.why)}};
  if (figure.metric->source == record::Source::certified) {
    out["base"] = json::interval("base", figure.base);
    out["new"] = json::interval("new", figure.now);
  } else {
    out["base"] = json::finite("base", figure.base.high);
    out["new"] = json::finite("new", figure.now.high);
  }
  if (figure.floor) out["floor"] = json::finite("floor", *figure.floor);
  if (figure.where) out["deepest"] = place_part(*figure.where);
  return out;
}

Json remarks_part(const std::vector<Remark>& remarks) {
  Json out = Json::array();
  for (const Remark& remark : remarks)
    out.push_back({{"id", remark.id},
                   {"judgement", id(remark.judgement)},
                   {"text", clean_text(remark.text)}});
  return out;
}

Json finding_part(const FindingChange& change) {
  Json out = {{"kind", clean_text(change.kind)},
              {"status", name(change)},
              {"judgement", id(change.judgement)}};
  if (change.base) out["base"] = place_part(*change.base);
  if (change.now) out["new"] = place_part(*change.now);
  if (change.base && change.now) out["moved_mm"] = json::finite("moved_mm", change.moved_mm);
  return out;
}

Json stage_part(const StageComparison& stage) {
  Json out = {{"name", clean_text(stage.name)}};
  if (stage.base) out["base_verdict"] = verifier::name(*stage.base);
  if (stage.now) out["new_verdict"] = verifier::name(*stage.now);
  out["remarks"] = remarks_part(stage.remarks);
  out["figures"] = Json::array();
  for (const FigureChange& figure : stage.figures) out["figures"].push_back(figure_part(figure));
  out["findings"] = Json::array();
  for (const FindingChange& change : stage.findings)
    out["findings"].push_back(finding_part(change));
  out["same_findings"] = stage.same_findings;
  return out;
}

}  // namespace

void write_json(const Comparison& comparison, std::ostream& out) {
  Json root = {{"schema", "limitgauge.compare/1"},   {"judgement", name(comparison.judgement())},
               {"worse", comparison.worse},          {"better", comparison.better},
               {"base", head_part(comparison.base)}, {"new", head_part(comparison.now)}};
  if (comparison.options.time_limit_percent)
    root["time_limit_percent"] = *comparison.options.time_limit_percent;
  root["remarks"] = remarks_part(comparison.remarks);
  root["stages"] = Json::array();
  for (const StageComparison& stage : comparison.stages)
    root["stages"].push_back(stage_part(stage));
  out << root.dump(1) << '\n';
}

}  // namespace limitgauge::reports::compare
