#include "reports/compare/selection.h"

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

}  // namespace limitgauge::reports::compare
