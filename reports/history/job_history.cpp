#include "reports/history/job_history.h"

#include <algorithm>
#include <map>
#include <utility>

#include "reports/compare/noise.h"
#include "reports/history/run_entry.h"

namespace limitgauge::reports::history_report {
namespace {

using Names = std::vector<std::string>;
/// Figures of one run, by stage and metric.
using Figures = std::map<std::pair<std::string, std::string>, verifier::Interval>;

bool holds(const Names& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

bool is_asked(const Choice& choice, const std::string& stage, const std::string& metric) {
  const bool by_default = metric == "gouge_mm" || metric == "uncut_mm" ||
                          record::is_over_tolerances(metric) ||
                          // Of all stages together, unless one is looked at.
                          (metric == "machining_time_s" && stage.empty() == choice.stages.empty());
  if (!choice.stages.empty() && !holds(choice.stages, stage)) return false;
  return choice.metrics.empty() ? by_default : holds(choice.metrics, metric);
}

Column column_of(const std::string& stage, const std::string& metric) {
  Column column{stage, metric, metric, "", record::find_metric(metric)};
  if (column.known == nullptr) return column;
  column.label = column.known->label;
  column.unit = column.known->unit;
  return column;
}

std::optional<double> limit_of(const Figures& figures, const Column& column) {
  std::string id = column.metric;
  const std::size_t unit = id.rfind("_mm");
  id.insert(unit == std::string::npos ? id.size() : unit, "_limit");
  const auto found = figures.find({column.stage, id});
  if (found == figures.end()) return std::nullopt;
  return found->second.high;
}

/// The names of the stages, in the order of the newest run; those of older jobs after them.
Names stages_of(std::span<const history::Entry* const> runs) {
  Names names = {""};
  for (auto run = runs.rbegin(); run != runs.rend(); ++run) {
    for (const history::StageVerdict& one : (*run)->stages)
      if (!holds(names, one.stage)) names.push_back(one.stage);
    // A history of the first version does not list them.
    for (const history::Value& one : (*run)->values)
      if (!holds(names, one.stage)) names.push_back(one.stage);
  }
  return names;
}

/// As reports list the metrics; what this program does not know after them.
std::size_t rank(const std::string& metric) {
  const std::span<const record::Metric> all = record::stage_metrics();
  return static_cast<std::size_t>(
      std::find_if(all.begin(), all.end(),
                   [&](const record::Metric& one) { return one.id == metric; }) -
      all.begin());
}

std::vector<Column> columns_of(std::span<const history::Entry* const> runs, const Choice& choice) {
  std::map<std::string, Names> metrics;
  for (const history::Entry* run : runs)
    for (const history::Value& one : run->values) {
      Names& known = metrics[one.stage];
      if (is_asked(choice, one.stage, one.metric) && !holds(known, one.metric))
        known.push_back(one.metric);
    }
  std::vector<Column> columns;
  for (const std::string& stage : stages_of(runs)) {
    Names& known = metrics[stage];
    std::stable_sort(known.begin(), known.end(),
                     [](const std::string& a, const std::string& b) { return rank(a) < rank(b); });
    for (const std::string& metric : known) columns.push_back(column_of(stage, metric));
  }
  return columns;
}

Figures figures_of(const history::Entry& run) {
  Figures figures;
  for (const history::Value& one : run.values)
    figures[{one.stage, one.metric}] = {one.low, one.high};
  return figures;
}

double greatest(const Figures& before, const Figures& now, const std::string& stage,
                const std::string& metric) {
  double most = 0;
  for (const Figures* figures : {&before, &now}) {
    const auto found = figures->find({stage, metric});
    if (found != figures->end()) most = std::max(most, found->second.high);
  }
  return most;
}

/// Figures of a run whose names begin so; of another box, those over tolerances say something else.
Figures tolerances_of(const Figures& figures) {
  Figures out;
  for (auto at = figures.lower_bound({"", kToleranceMetric});
       at != figures.end() && at->first.first.empty() &&
       at->first.second.starts_with(kToleranceMetric);
       ++at)
    out.insert(*at);
  return out;
}

bool same_interval(const verifier::Interval& a, const verifier::Interval& b) {
  return a.low == b.low && a.high == b.high;
}

bool same_tolerances(const Figures& before, const Figures& now) {
  const Figures a = tolerances_of(before), b = tolerances_of(now);
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& x, const auto& y) {
    return x.first == y.first && same_interval(x.second, y.second);
  });
}

bool same_limits(const Figures& before, const Figures& now, const std::string& stage) {
  for (const char* metric : {"robust_gouge_limit_mm", "robust_uncut_limit_mm"}) {
    const auto a = before.find({stage, metric}), b = now.find({stage, metric});
    if ((a == before.end()) != (b == now.end())) return false;
    if (a != before.end() && !same_interval(a->second, b->second)) return false;
  }
  return true;
}

/// Figures over other tolerances, and margins of other limits, are not held against each other.
bool is_same_question(const Column& column, const Figures& before, const Figures& now) {
  if (!record::is_over_tolerances(column.metric)) return true;
  return same_tolerances(before, now) &&
         (column.metric != "margin" || same_limits(before, now, column.stage));
}

double middle(const Column& column, const verifier::Interval& figure) {
  const bool is_margin = column.known != nullptr && compare::is_margin(*column.known);
  return is_margin ? figure.low : (figure.low + figure.high) / 2;
}

void judge(const Column& column, const Figures& before, const Figures& now,
           const verifier::Interval& earlier, Cell& cell) {
  const double change = middle(column, *cell.value) - middle(column, earlier);
  cell.direction = change > 0 ? 1 : change < 0 ? -1 : 0;
  if (column.known == nullptr || !is_same_question(column, before, now)) return;
  const compare::Fineness fineness{greatest(before, now, column.stage, "resolution_mm"),
                                   greatest(before, now, column.stage, "voxel_mm")};
  cell.judgement = compare::judge_figure(*column.known, earlier, *cell.value, fineness);
}

/// The time of a run that stopped at a stage is that of another job: nothing to judge by.
bool is_comparable(const Column& column, const history::Entry& run) {
  return !column.stage.empty() ||
         std::none_of(run.stages.begin(), run.stages.end(),
                      [](const history::StageVerdict& one) { return one.verdict == "not_run"; });
}

/// Lengths and times of paths mean what they always meant.
bool depends_on_schema(const Column& column) {
  return column.known != nullptr && (column.known->source == record::Source::certified ||
                                     column.known->source == record::Source::measured);
}

JobHistory history_of(std::span<const history::Entry* const> runs, const Choice& choice) {
  JobHistory job{runs.front()->job, columns_of(runs, choice), {}};
  // Of each column the last run that has it: what the next one is held against.
  std::vector<const Figures*> last(job.columns.size(), nullptr);
  std::vector<int> schema(job.columns.size(), 0);
  std::vector<Figures> figures;
  figures.reserve(runs.size());
  for (const history::Entry* entry : runs) {
    const Figures& now = figures.emplace_back(figures_of(*entry));
    Run& run = job.runs.emplace_back(Run{*entry, std::vector<Cell>(job.columns.size())});
    run.entry.values.clear();
    for (std::size_t i = 0; i < job.columns.size(); ++i) {
      const Column& column = job.columns[i];
      const auto found = now.find({column.stage, column.metric});
      if (found == now.end()) continue;
      Cell& cell = run.cells[i];
      cell.value = found->second;
      cell.limit = limit_of(now, column);
      if (!is_comparable(column, *entry)) continue;
      cell.new_meaning =
          last[i] != nullptr && schema[i] != entry->result_schema && depends_on_schema(column);
      schema[i] = entry->result_schema;
      if (last[i] != nullptr && !cell.new_meaning)
        judge(column, *last[i], now, last[i]->at({column.stage, column.metric}), cell);
      last[i] = &now;
    }
  }
  return job;
}

}  // namespace

bool JobHistory::changes_meaning() const {
  return std::any_of(runs.begin(), runs.end(), [](const Run& run) {
    return std::any_of(run.cells.begin(), run.cells.end(),
                       [](const Cell& cell) { return cell.new_meaning; });
  });
}

std::vector<std::string> metrics_to_read(const Choice& choice,
                                         std::span<const history::Series> series) {
  Names names = {"gouge_mm",
                 "uncut_mm",
                 "robust_gouge_mm",
                 "robust_uncut_mm",
                 "margin",
                 "machining_time_s",
                 "robust_gouge_limit_mm",
                 "robust_uncut_limit_mm",
                 "gouge_limit_mm",
                 "uncut_limit_mm",
                 "coverage_limit",
                 "unavoidable_uncut_limit_mm",
                 "unreachable_area_limit_mm2",
                 "resolution_mm",
                 "voxel_mm"};
  for (const history::Series& one : series)
    if (one.metric.starts_with(kToleranceMetric)) names.push_back(one.metric);
  for (const std::string& metric : choice.metrics)
    if (!holds(names, metric)) names.push_back(metric);
  return names;
}

std::vector<JobHistory> job_histories(std::span<const history::Entry> runs, const Choice& choice) {
  std::map<std::string, std::vector<const history::Entry*>> jobs;
  for (const history::Entry& run : runs) jobs[run.job].push_back(&run);
  std::vector<JobHistory> all;
  for (const auto& [name, entries] : jobs) all.push_back(history_of(entries, choice));
  return all;
}

}  // namespace limitgauge::reports::history_report
