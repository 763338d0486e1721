#include "app/study/study_figures.h"

#include <algorithm>
#include <iterator>
#include <string_view>

#include "reports/record/metrics.h"

namespace limitgauge::app {
namespace {

using reports::record::Better;
using reports::record::DeviationMeasures;
using reports::record::is_over_tolerances;
using reports::record::Metric;
using reports::record::RunRecord;
using reports::record::Source;
using reports::record::StageMeasures;
using reports::record::StageRecord;
using verifier::Verdict;

std::vector<const Metric*> metrics(const FigureScope& scope) {
  std::vector<const Metric*> kept;
  for (const Metric& metric : reports::record::stage_metrics()) {
    const bool is_there = scope.over_tolerances || !is_over_tolerances(metric.id);
    if (metric.source != Source::effort && is_there) kept.push_back(&metric);
  }
  return kept;
}

/// The only certified figure that is to be large.
bool is_margin(const Metric& metric) {
  return metric.source == Source::certified && metric.better == Better::higher;
}

void add_figures(std::vector<study::Figure>& all, const std::string& stage, const Metric& metric) {
  const std::string id = stage + "." + std::string(metric.id);
  const std::string label = stage + ": " + std::string(metric.label);
  const std::string unit(metric.unit);
  if (metric.source != Source::certified) {
    all.push_back({id, label, unit});
    return;
  }
  const bool optional = is_over_tolerances(metric.id), margin = is_margin(metric);
  all.push_back({id + ".low", label + (margin ? ", proven" : ", reached"), unit, optional, margin});
  all.push_back(
      {id + ".high", label + (margin ? ", refuted" : ", certified"), unit, optional, margin});
}

/// Excess in parts of the limit, or of `least` where that is more.
double relative(double figure, double limit, double least) {
  return (figure - limit) / std::max(limit, least);
}

/// Of the limits of one stage; what is at most 0 is kept.
std::vector<double> excesses(const DeviationMeasures& measures,
                             const verifier::GateLimits& limits) {
  std::vector<double> all;
  if (limits.has_gouge && limits.gouge_mm > 0)
    all.push_back((std::max(judged_gouge_mm(measures).high, measures.missing_stock_mm.high) -
                   limits.gouge_mm) /
                  limits.gouge_mm);
  if (limits.has_uncut && limits.uncut_mm > 0)
    all.push_back((judged_uncut_mm(measures).high - limits.uncut_mm) / limits.uncut_mm);
  if (limits.has_coverage) {
    // Where all has to be covered, a thousandth of the area is one limit's worth.
    const double may_be_left = std::max(1 - limits.coverage, 1e-3);
    all.push_back((limits.coverage - measures.coverage) / may_be_left);
  }
  // Where nothing may be out of reach, likewise; a micrometre or a hundredth of a mm² of what may
  // not be at all.
  if (limits.has_unreachable)
    all.push_back(relative(unreachable_figure(measures, limits.unreachable_is_share).high,
                           limits.unreachable, limits.unreachable_is_share ? 1e-3 : 1e-2));
  if (limits.has_unavoidable)
    all.push_back(relative(measures.unavoidable_mm.high, limits.unavoidable_mm, 1e-3));
  return all;
}

/// Of a stage that fails though every certified figure keeps its limit.
double other_excess(const StageRecord& stage) {
  const StageMeasures& measures = *stage.measures;
  double faults = 0;
  for (const reports::record::ProcessCount& fault : measures.process)
    faults += static_cast<double>(fault.count);
  return faults > 0 ? faults : 1;
}

std::optional<double> stage_excess(const StageRecord& stage) {
  std::vector<double> all;
  if (stage.measures->deviation) all = excesses(*stage.measures->deviation, stage.limits);
  std::optional<double> worst;
  if (!all.empty()) worst = *std::max_element(all.begin(), all.end());
  if (stage.verdict != Verdict::pass && !(worst && *worst > 0)) worst = other_excess(stage);
  return worst;
}

const char* judged(const verifier::Interval& figure, double limit) {
  return figure.low > limit ? " beyond its limit" : " not decided at this resolution";
}

template <class Add>
void add_reach(const DeviationMeasures& measures, const verifier::GateLimits& limits,
               const Add& add) {
  const verifier::Interval area_mm2 = unreachable_figure(measures, false),
                           figure = unreachable_figure(measures, limits.unreachable_is_share);
  if (area_mm2.high > 0 && measures.reach.reachable_mm2 <= 0 && measures.reachable_area_mm2 <= 0)
    add("nothing in reach");
  if (limits.has_unreachable && figure.high > limits.unreachable)
    add(std::string("unreachable area") + judged(figure, limits.unreachable));
  if (limits.has_unavoidable && measures.unavoidable_mm.high > limits.unavoidable_mm)
    add(std::string("unavoidable uncut") + judged(measures.unavoidable_mm, limits.unavoidable_mm));
}

template <class Add>
void add_limits(const DeviationMeasures& measures, const verifier::GateLimits& limits,
                const Add& add) {
  const std::string over = measures.robust ? " over tolerances" : "";
  const verifier::Interval &gouge_mm = judged_gouge_mm(measures),
                           &uncut_mm = judged_uncut_mm(measures);
  if (limits.has_gouge && gouge_mm.high > limits.gouge_mm)
    add("gouge" + over + judged(gouge_mm, limits.gouge_mm));
  if (limits.has_uncut && uncut_mm.high > limits.uncut_mm)
    add("uncut" + over + judged(uncut_mm, limits.uncut_mm));
  if (limits.has_gouge && measures.missing_stock_mm.high > limits.gouge_mm)
    add(std::string("missing stock") + judged(measures.missing_stock_mm, limits.gouge_mm));
  if (limits.has_coverage && measures.coverage < limits.coverage) add("coverage too small");
  add_reach(measures, limits, add);
}

/// What keeps the stage from passing, in a few words.
std::string reason_of(const StageRecord& stage) {
  std::string reason;
  const auto add = [&](const std::string& what) { reason += (reason.empty() ? "" : ", ") + what; };
  if (stage.measures) {
    if (stage.measures->deviation) add_limits(*stage.measures->deviation, stage.limits, add);
    for (const reports::record::ProcessCount& fault : stage.measures->process) {
      std::string kind = fault.kind;
      std::replace(kind.begin(), kind.end(), '_', ' ');
      if (fault.count > 0) add(kind);
    }
  }
  if (reason.empty()) reason = stage.reasons.empty() ? "not passed" : stage.reasons.back();
  return stage.name + ": " + reason;
}

std::string reason_of(const RunRecord& run) {
  for (const StageRecord& stage : run.stages)
    if (stage.verdict != Verdict::pass) return reason_of(stage);
  return {};
}

study::Status status_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::pass:
      return study::Status::pass;
    case Verdict::fail:
      return study::Status::fail;
    case Verdict::indeterminate:
      return study::Status::indeterminate;
    case Verdict::not_run:
      break;
  }
  return study::Status::error;
}

void add_values(std::vector<std::optional<double>>& all, const StageRecord* stage,
                const Metric& metric) {
  std::optional<verifier::Interval> value;
  if (stage != nullptr && stage->measures) value = metric.of(*stage->measures);
  all.push_back(value ? std::optional(value->low) : std::nullopt);
  if (metric.source == Source::certified)
    all.push_back(value ? std::optional(value->high) : std::nullopt);
}

const StageRecord* stage_named(const RunRecord& run, const std::string& name) {
  for (const StageRecord& stage : run.stages)
    if (stage.name == name) return &stage;
  return nullptr;
}

/// True where less is better, or where someone may want to pay with it.
bool can_be_objective(const Metric& metric) {
  constexpr std::string_view kWanted[] = {"p99_mm", "cut_length_mm", "rapid_length_mm", "moves"};
  return metric.better == Better::lower ||
         std::find(std::begin(kWanted), std::end(kWanted), metric.id) != std::end(kWanted);
}

/// Of a job that came to its last stage: what a part of the stages takes says nothing of the whole.
std::optional<double> whole_machining_time_s(const RunRecord& run) {
  const auto ran = [](const StageRecord& stage) { return stage.measures.has_value(); };
  if (!std::all_of(run.stages.begin(), run.stages.end(), ran)) return std::nullopt;
  return reports::record::machining_time_s(run);
}

}  // namespace

FigureScope figure_scope(const Job& job, std::span<const std::string> keys) {
  FigureScope scope;
  for (const JobStage& stage : job.stages) scope.stages.push_back(stage.name);
  scope.over_tolerances =
      job.tolerances || std::any_of(keys.begin(), keys.end(), [](const std::string& key) {
        return key == "tolerances" || key.starts_with("tolerances.");
      });
  return scope;
}

std::vector<study::Figure> study_figures(const FigureScope& scope) {
  std::vector<study::Figure> all = {{"machining_time_s", "machining time", "s"},
                                    {"gate_excess", "largest excess over a limit", ""}};
  for (const std::string& stage : scope.stages)
    for (const Metric* metric : metrics(scope)) add_figures(all, stage, *metric);
  return all;
}

std::vector<std::string> objective_ids(const FigureScope& scope) {
  std::vector<std::string> ids = {"machining_time_s", "gate_excess"};
  for (const std::string& stage : scope.stages) {
    for (const Metric* metric : metrics(scope)) {
      // What is refuted of a margin promises nothing.
      if (is_margin(*metric)) ids.push_back(stage + "." + std::string(metric->id) + ".low");
      if (!can_be_objective(*metric)) continue;
      std::vector<study::Figure> figures;
      add_figures(figures, stage, *metric);
      for (study::Figure& figure : figures) ids.push_back(std::move(figure.id));
    }
  }
  return ids;
}

std::optional<double> gate_excess(const RunRecord& run) {
  std::optional<double> worst;
  for (const StageRecord& stage : run.stages) {
    if (!stage.measures) continue;
    const std::optional<double> excess = stage_excess(stage);
    if (excess && (!worst || *excess > *worst)) worst = excess;
  }
  return worst;
}

void fill_row(study::Row& row, const RunRecord& run, const FigureScope& scope) {
  row.status = status_of(run.verdict);
  row.reason = row.status == study::Status::pass ? std::string() : reason_of(run);
  row.figures = {whole_machining_time_s(run), gate_excess(run)};
  for (const std::string& name : scope.stages)
    for (const Metric* metric : metrics(scope))
      add_values(row.figures, stage_named(run, name), *metric);
}

}  // namespace limitgauge::app
