#include "reports/compare/comparison.h"

#include <algorithm>

namespace limitgauge::reports::compare {
namespace {

bool holds(const std::vector<std::string>& ids, std::string_view id) {
  return std::find(ids.begin(), ids.end(), id) != ids.end();
}

}  // namespace

std::vector<std::string_view> judged_ids() {
  std::vector<std::string_view> ids;
  for (const record::Metric& metric : record::stage_metrics())
    if (metric.better != record::Better::neither && metric.source != record::Source::effort)
      ids.push_back(metric.id);
  ids.insert(ids.end(), {"gate", "process"});
  return ids;
}

bool is_judged(const Options& options, std::string_view id) {
  return (options.only.empty() || holds(options.only, id)) && !holds(options.ignored, id);
}

Judgement if_judged(const Options& options, std::string_view id, Judgement judgement) {
  return is_judged(options, id) ? judgement : Judgement::not_judged;
}

FoundPlace found_place(const record::Place& place) {
  return {place.at_mm, place.depth_mm,  place.stage,
          place.line,  place.line_text, place.body == "cutter" ? std::string{} : place.body};
}

FoundPlace found_place(const record::ProcessFinding& finding, const std::string& stage) {
  std::string by = finding.part;
  if (!finding.against.empty() && finding.against != "stock") by += ", " + finding.against;
  return {finding.at_mm, finding.depth_mm, stage, finding.line, finding.line_text, by};
}

double depth_mm(const FindingChange& change) {
  return change.now ? change.now->depth_mm : change.base ? change.base->depth_mm : 0;
}

Judgement Comparison::judgement() const {
  if (worse > 0) return Judgement::worse;
  return better > 0 ? Judgement::better : Judgement::same;
}

}  // namespace limitgauge::reports::compare
