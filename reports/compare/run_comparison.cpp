#include "reports/compare/run_comparison.h"

#include <algorithm>
#include <map>
#include <set>

#include "model/base/error.h"

namespace limitgauge::reports::compare {
namespace {

using record::RunRecord;
using record::StageRecord;

/// Of the diagonal of the surface's box: findings that lie closer together are taken for one.
constexpr double kReachShare = 0.01;

struct StagePair {
  const StageRecord* base = nullptr;
  const StageRecord* now = nullptr;
};

/// By name, of equal names one after the other: the new run's stages in their order, then those
/// that only the base run has.
std::vector<StagePair> paired_stages(const RunRecord& base, const RunRecord& now) {
  std::multimap<std::string, const StageRecord*> of_base;
  for (const StageRecord& stage : base.stages) of_base.emplace(stage.name, &stage);
  std::vector<StagePair> out;
  std::set<const StageRecord*> paired;
  for (const StageRecord& stage : now.stages) {
    const auto found = of_base.lower_bound(stage.name);
    const bool has = found != of_base.end() && found->first == stage.name;
    out.push_back({has ? found->second : nullptr, &stage});
    if (!has) continue;
    paired.insert(found->second);
    of_base.erase(found);
  }
  for (const StageRecord& stage : base.stages)
    if (!paired.contains(&stage)) out.push_back({&stage, nullptr});
  return out;
}

void add(std::vector<Remark>& to, std::vector<Remark> remarks) {
  std::move(remarks.begin(), remarks.end(), std::back_inserter(to));
}

void compare_deviations(const record::DeviationMeasures& base, const record::DeviationMeasures& now,
                        StageComparison& out) {
  add(out.remarks, compare_certificates(base, now));
  if (std::optional<Remark> remark = tell_reach(base, now))
    out.remarks.push_back(std::move(*remark));
}

/// What the gate holds a certified length or the coverage against.
std::optional<double> limit_of(const record::Metric& metric, const StageRecord& stage) {
  const verifier::GateLimits& limits = stage.limits;
  const bool is_robust = stage.measures->deviation && stage.measures->deviation->robust;
  const auto stated = [](bool has, double value) {
    return has ? std::optional(value) : std::nullopt;
  };
  if (metric.id == (is_robust ? "robust_gouge_mm" : "gouge_mm") || metric.id == "missing_stock_mm")
    return stated(limits.has_gouge, limits.gouge_mm);
  if (metric.id == (is_robust ? "robust_uncut_mm" : "uncut_mm"))
    return stated(limits.has_uncut, limits.uncut_mm);
  if (metric.id == "coverage") return stated(limits.has_coverage, limits.coverage);
  return std::nullopt;
}

void compare_stages(const StageRecord& base, const StageRecord& now, const RunContext& run,
                    StageComparison& out) {
  const Options& options = run.options;
  if (std::optional<Remark> remark = compare_verdicts("verdict", base.verdict, now.verdict))
    out.remarks.push_back(std::move(*remark));
  add(out.remarks, compare_gates(base.limits, now.limits, options));
  add(out.remarks, compare_settings(base, now, options));
  if (!base.measures || !now.measures) return;
  if (base.measures->deviation && now.measures->deviation)
    compare_deviations(*base.measures->deviation, *now.measures->deviation, out);
  add(out.remarks, compare_process_counts(*base.measures, *now.measures, options));
  add(out.remarks, tell_lone_figures(*base.measures, *now.measures));
  out.figures = compare_figures(*base.measures, *now.measures, options);
  leave_other_questions(base, now, run.same_tolerances, out.figures);
  for (FigureChange& figure : out.figures) {
    figure.base_limit = limit_of(*figure.metric, base);
    figure.now_limit = limit_of(*figure.metric, now);
  }
  compare_findings(base, now, run, out);
}

StageComparison compare_pair(const StagePair& pair, const RunContext& run) {
  StageComparison out;
  out.name = (pair.now ? pair.now : pair.base)->name;
  if (pair.base) out.base = pair.base->verdict;
  if (pair.now) out.now = pair.now->verdict;
  if (!pair.now)
    out.remarks.push_back({"stage", Judgement::worse, "the new run has no such stage"});
  else if (!pair.base)
    out.remarks.push_back({"stage", Judgement::not_judged, "the base run has no such stage"});
  else
    compare_stages(*pair.base, *pair.now, run, out);
  return out;
}

RunHead head_of(const RunRecord& run) {
  return {run.job, run.version, run.created, {}, run.verdict, record::machining_time_s(run)};
}

void require_common(const RunRecord& base, const RunRecord& now,
                    const std::vector<StagePair>& pairs) {
  const bool has_common =
      std::any_of(pairs.begin(), pairs.end(), [](const StagePair& p) { return p.base && p.now; });
  if (has_common || base.job == now.job) return;
  throw model::InputError({},
                          "these are results of two jobs (" + base.job + " and " + now.job +
                              ") with no stage of one name",
                          "two results of one job");
}

/// Held against each other, such figures would rise or fall by what their names mean.
void require_one_schema(const RunRecord& base, const RunRecord& now) {
  if (base.schema == now.schema) return;
  const auto name = [](const RunRecord& run) {
    return "limitgauge.result/" + std::to_string(run.schema);
  };
  const bool base_is_older = base.schema < now.schema;
  throw model::InputError(
      {},
      "the base is of schema " + name(base) + " and the new result of " + name(now) +
          ", and gouge and uncut do not mean the same in both: since /2 they are runs along the "
          "normal (definition 2), in /1 they were distances to the nearest removed space or "
          "material",
      std::string("two results of one schema; make the ") +
          (base_is_older ? "baseline" : "new one") + " again with this limitgauge");
}

/// Where one of them says nothing of a surface, most of what the other says has no counterpart: a
/// gouge could vanish without a word.
void require_one_kind(const RunRecord& base, const RunRecord& now) {
  if (base.cage.has_value() == now.cage.has_value()) return;
  const auto words = [](const RunRecord& run) {
    return run.cage ? "was measured against a design" : "is of a program cut without a design";
  };
  throw model::InputError(
      {}, std::string("the base ") + words(base) + " and the new result " + words(now),
      "two results against a design, or two without one");
}

void count(Comparison& out) {
  const auto add_one = [&out](Judgement judgement) {
    if (judgement == Judgement::worse) ++out.worse;
    if (judgement == Judgement::better) ++out.better;
  };
  for (const Remark& remark : out.remarks) add_one(remark.judgement);
  for (const StageComparison& stage : out.stages) {
    for (const Remark& remark : stage.remarks) add_one(remark.judgement);
    for (const FigureChange& figure : stage.figures) add_one(figure.judgement);
    for (const FindingChange& finding : stage.findings) add_one(finding.judgement);
  }
}

}  // namespace

Comparison compare_runs(const RunRecord& base, const RunRecord& now, const Options& options) {
  require_one_schema(base, now);
  require_one_kind(base, now);
  const std::vector<StagePair> pairs = paired_stages(base, now);
  require_common(base, now, pairs);
  Comparison out;
  out.base = head_of(base);
  out.now = head_of(now);
  out.options = options;
  if (std::optional<Remark> remark =
          compare_verdicts("the run's verdict", base.verdict, now.verdict))
    out.remarks.push_back(std::move(*remark));
  add(out.remarks, compare_heads(base, now));
  add(out.remarks, compare_process_limits(base.process_limits, now.process_limits, options));
  const std::optional<Remark> box = compare_tolerances(base.tolerances, now.tolerances, options);
  if (box) out.remarks.push_back(*box);
  const RunContext run{kReachShare * std::max(base.diagonal_mm, now.diagonal_mm), !box, options};
  for (const StagePair& pair : pairs) out.stages.push_back(compare_pair(pair, run));
  count(out);
  return out;
}

}  // namespace limitgauge::reports::compare
