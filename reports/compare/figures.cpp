#include "reports/compare/run_comparison.h"

#include <algorithm>
#include <cmath>

#include "reports/compare/comparison_text.h"
#include "reports/compare/noise.h"
#include "reports/text/text.h"

namespace limitgauge::reports::compare {
namespace {

using record::DeviationMeasures;
using record::Metric;
using record::Source;
using record::StageMeasures;
using verifier::Interval;

/// How far the samples go to the side of a figure; none for one that they do not tell of.
std::optional<double> sampled_extreme(const Metric& metric, const DeviationMeasures& measures) {
  if (!measures.sampled_mm) return std::nullopt;
  if (metric.id == "gouge_mm") return -measures.sampled_mm->low;
  if (metric.id == "uncut_mm") return measures.sampled_mm->high;
  return std::nullopt;
}

/// Three readings that agree: the place that is proved to be reached, the bound that is promised,
/// and the extreme of the samples, which are exact and lie in the same places in both runs.
/// Intervals that overlap may hide a change that they show; and where nothing changed, no sample
/// did.
bool all_rose(const Metric& metric, const StageMeasures& from, const StageMeasures& to,
              const Fineness& fineness) {
  const auto sampled_from = sampled_extreme(metric, *from.deviation),
             sampled_to = sampled_extreme(metric, *to.deviation);
  if (!sampled_from || !sampled_to) return false;
  const double floor = sample_floor_mm(fineness);
  const Interval was = *metric.of(from), is = *metric.of(to);
  return is.low - was.low > floor && is.high - was.high > floor &&
         *sampled_to - *sampled_from > floor;
}

void judge_certified(FigureChange& change, const StageMeasures& base, const StageMeasures& now,
                     const Fineness& fineness) {
  const Metric& metric = *change.metric;
  change.judgement = judge_figure(metric, change.base, change.now, fineness);
  const double promise = change.now.high - change.base.high;
  const std::string floor = stated_length(*change.floor);
  if (wholly_above(change.now, change.base)) {
    change.why = "proved: the new interval lies wholly above the old one";
  } else if (wholly_above(change.base, change.now)) {
    change.why = "proved: the new interval lies wholly below the old one";
  } else if (change.judgement != Judgement::same) {
    change.why = std::string("the bound that is promised ") + (promise > 0 ? "grew" : "fell") +
                 " by " + measured_length(std::abs(promise)) + ", more than the resolution of " +
                 floor;
  } else if (all_rose(metric, base, now, fineness)) {
    change.judgement = Judgement::worse;
    change.why =
        "the depth reached, the bound promised and the deepest sample all grew by more than " +
        stated_length(sample_floor_mm(fineness));
  } else if (all_rose(metric, now, base, fineness)) {
    change.judgement = Judgement::better;
    change.why =
        "the depth reached, the bound promised and the deepest sample all fell by more than " +
        stated_length(sample_floor_mm(fineness));
  } else {
    change.why = "the intervals meet, and the bound promised moved by no more than " + floor +
                 ", the resolution";
  }
}

void judge_margin(FigureChange& change, const Fineness& fineness) {
  change.judgement = judge_figure(*change.metric, change.base, change.now, fineness);
  if (change.judgement == Judgement::worse)
    change.why = "proved: what the new run refutes was proven before";
  else if (change.judgement == Judgement::better)
    change.why = "proved: what the new run proves was refuted before";
  else
    change.why = "the intervals from proven to refuted meet, or lie within a thousandth";
}

std::string why_measured(const FigureChange& change) {
  const std::string_view id = change.metric->id;
  const std::string where = change.judgement == Judgement::same ? "within " : "beyond ";
  if (id == "coverage") return where + "a tenth of a point: samples on the rim change sides";
  if (id.starts_with("voxel_")) return where + "a voxel of the stock";
  return where + "a tenth of the resolution";
}

/// Longer is worse only from the stated limit on, shorter is better as soon as it is not rounding.
void judge_time(FigureChange& change, const Options& options) {
  if (!options.time_limit_percent) {
    change.why = "shown; judged with --time-limit only";
    return;
  }
  change.why = "may grow by " + three_digits(*options.time_limit_percent) + " %";
  const double base = change.base.high, grown = change.now.high - base;
  change.floor = noise_floor(*change.metric, base, {});
  if (grown > 0) change.floor = std::max(*change.floor, *options.time_limit_percent / 100 * base);
  if (std::abs(grown) <= *change.floor)
    change.judgement = Judgement::same;
  else
    change.judgement = grown > 0 ? Judgement::worse : Judgement::better;
}

void judge(FigureChange& change, const StageMeasures& base, const StageMeasures& now,
           const Options& options) {
  const Metric& metric = *change.metric;
  const Fineness fineness = fineness_of(base, now);
  if (metric.source == Source::effort) {
    change.why = "of this program on its machine; never judged";
  } else if (metric.better == record::Better::neither) {
    change.why = "shown; neither way is better by itself";
  } else if (!is_judged(options, metric.id)) {
    change.why = "not asked for";
  } else if (metric.source == Source::planned) {
    judge_time(change, options);
  } else {
    change.floor = noise_floor(metric, record::promised(metric, change.base), fineness);
    if (is_margin(metric)) return judge_margin(change, fineness);
    if (metric.source == Source::certified) return judge_certified(change, base, now, fineness);
    change.judgement = judge_figure(metric, change.base, change.now, fineness);
    change.why = why_measured(change);
  }
}

/// A figure that gets worse is named with the place in the new run, one that gets better with the
/// place that the base run had.
std::optional<FoundPlace> deepest(const FigureChange& change,
                                  const std::vector<record::Place>& base,
                                  const std::vector<record::Place>& now) {
  const std::vector<record::Place>& run = change.judgement == Judgement::better ? base : now;
  if (run.empty() || change.metric->source != Source::certified) return std::nullopt;
  return found_place(*std::max_element(run.begin(), run.end(), [](const auto& a, const auto& b) {
    return a.depth_mm < b.depth_mm;
  }));
}

std::vector<record::Place> alone(const std::optional<record::Place>& place) {
  return place ? std::vector{*place} : std::vector<record::Place>{};
}

/// Of a figure of the design; none where there is no design. Of a figure over tolerances the place
/// that reaches it.
std::vector<record::Place> places_of(const Metric& metric, const StageMeasures& stage) {
  if (!stage.deviation) return {};
  const DeviationMeasures& measures = *stage.deviation;
  if (measures.robust && metric.id == "robust_gouge_mm") return alone(measures.robust->gouge);
  if (measures.robust && metric.id == "robust_uncut_mm") return alone(measures.robust->uncut);
  if (metric.id == "gouge_mm") return measures.gouges;
  if (metric.id == "uncut_mm") return measures.uncuts;
  return metric.id == "missing_stock_mm" ? measures.missing_stock : std::vector<record::Place>{};
}

/// "tolerance margin ([1.07, 1.08])"
std::string lone_words(const Metric& metric, const Interval& figure) {
  FigureChange alone;
  alone.metric = &metric;
  alone.base = alone.now = figure;
  return std::string(metric.label) + " (" + figure_text(alone).now + ")";
}

}  // namespace

std::vector<Remark> tell_lone_figures(const StageMeasures& base, const StageMeasures& now) {
  std::string of_base, of_now;
  for (const Metric& metric : record::stage_metrics()) {
    const std::optional<Interval> was = metric.of(base), is = metric.of(now);
    if (was.has_value() == is.has_value()) continue;
    std::string& words = was ? of_base : of_now;
    words += (words.empty() ? "" : ", ") + lone_words(metric, was ? *was : *is);
  }
  std::vector<Remark> out;
  if (!of_base.empty())
    out.push_back({"figure", Judgement::not_judged, "only the base run has " + of_base});
  if (!of_now.empty())
    out.push_back({"figure", Judgement::not_judged, "only the new run has " + of_now});
  return out;
}

std::vector<FigureChange> compare_figures(const StageMeasures& base, const StageMeasures& now,
                                          const Options& options) {
  std::vector<FigureChange> out;
  for (const Metric& metric : record::stage_metrics()) {
    const std::optional<Interval> was = metric.of(base), is = metric.of(now);
    if (!was || !is) continue;
    FigureChange change;
    change.metric = &metric;
    change.base = *was;
    change.now = *is;
    judge(change, base, now, options);
    change.where = deepest(change, places_of(metric, base), places_of(metric, now));
    out.push_back(std::move(change));
  }
  return out;
}

}  // namespace limitgauge::reports::compare
