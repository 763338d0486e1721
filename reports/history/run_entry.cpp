#include "reports/history/run_entry.h"

#include "reports/record/metrics.h"
#include "reports/record/tolerance_ranges.h"

namespace limitgauge::reports::history_report {
namespace {

void add_limits(const record::StageRecord& stage, std::vector<history::Value>& values) {
  const auto add = [&](bool stated, const char* metric, double limit) {
    if (stated) values.push_back({stage.name, metric, limit, limit});
  };
  // Of the figures that the gate held against them.
  const auto& deviation = stage.measures->deviation;
  const bool is_robust = deviation && deviation->robust;
  add(stage.limits.has_gouge, is_robust ? "robust_gouge_limit_mm" : "gouge_limit_mm",
      stage.limits.gouge_mm);
  add(stage.limits.has_uncut, is_robust ? "robust_uncut_limit_mm" : "uncut_limit_mm",
      stage.limits.uncut_mm);
  add(stage.limits.has_coverage, "coverage_limit", stage.limits.coverage);
  add(stage.limits.has_unavoidable, "unavoidable_uncut_limit_mm", stage.limits.unavoidable_mm);
  add(stage.limits.has_unreachable,
      stage.limits.unreachable_is_share ? "unreachable_limit" : "unreachable_area_limit_mm2",
      stage.limits.unreachable);
}

void add_fineness(const record::StageRecord& stage, std::vector<history::Value>& values) {
  const double voxel = stage.measures->voxel_mm;
  if (const auto& deviation = stage.measures->deviation)
    values.push_back(
        {stage.name, "resolution_mm", deviation->resolution_mm, deviation->resolution_mm});
  values.push_back({stage.name, "voxel_mm", voxel, voxel});
}

}  // namespace

namespace {

void add_tolerances(const model::Tolerances& tolerances, std::vector<history::Value>& values) {
  for (const auto& [name, range] : record::tolerance_ranges(tolerances))
    values.push_back({"", std::string(kToleranceMetric) + name, range.low, range.high});
}

}  // namespace

history::Entry entry_of(const record::RunRecord& run) {
  history::Entry entry;
  entry.created = run.created;
  entry.job = run.job;
  entry.version = run.version;
  entry.verdict = verifier::name(run.verdict);
  entry.result_schema = run.schema;
  const double whole_s = record::machining_time_s(run);
  entry.values.push_back({"", "machining_time_s", whole_s, whole_s});
  if (run.tolerances) add_tolerances(*run.tolerances, entry.values);
  for (const record::StageRecord& stage : run.stages) {
    entry.stages.push_back({stage.name, verifier::name(stage.verdict)});
    if (!stage.measures) continue;
    for (const record::Metric& metric : record::stage_metrics()) {
      if (const std::optional<verifier::Interval> figure = metric.of(*stage.measures))
        entry.values.push_back({stage.name, std::string(metric.id), figure->low, figure->high});
    }
    add_limits(stage, entry.values);
    add_fineness(stage, entry.values);
  }
  return entry;
}

}  // namespace limitgauge::reports::history_report
