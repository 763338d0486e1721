#include "reports/compare/figures.h"

#include <algorithm>
#include <cmath>

#include "reports/compare/noise.h"
#include "reports/compare/places.h"
#include "reports/compare/selection.h"
#include "reports/text.h"

namespace limitgauge::reports::compare {
namespace {

using record::Metric;
using record::Source;
using record::StageMeasures;

std::string why_certified(const FigureChange& change) {
  if (wholly_above(change.now, change.base))
    return "proved: the new interval lies wholly above the old one";
  if (wholly_above(change.base, change.now))
    return "proved: the new interval lies wholly below the old one";
  const double promise = change.now.high - change.base.high;
  const std::string floor = stated_length(*change.floor);
  if (change.judgement == Judgement::same)
    return "the intervals meet, and the bound that is promised moved by no more than " + floor +
           ", the resolution";
  return std::string("the bound that is promised ") + (promise > 0 ? "grew" : "fell") + " by " +
         measured_length(std::abs(promise)) + ", more than the resolution of " + floor;
}

std::string why_measured(const Metric& metric) {
  if (metric.id == "coverage") return "samples on the rim of a limit change sides";
  if (metric.id.starts_with("voxel_")) return "no finer than the stock's voxels";
  return "no statistic moves further than the deviation does somewhere";
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

void judge(FigureChange& change, const Fineness& fineness, const Options& options) {
  const Metric& metric = *change.metric;
  if (metric.source == Source::effort) {
    change.why = "of this program on its machine; never judged";
  } else if (metric.better == record::Better::neither) {
    change.why = "neither way is better";
  } else if (!is_judged(options, metric.id)) {
    change.why = "not asked for";
  } else if (metric.source == Source::planned) {
    judge_time(change, options);
  } else {
    change.floor = noise_floor(metric, change.base.high, fineness);
    change.judgement = judge_figure(metric, change.base, change.now, fineness);
    change.why = metric.source == Source::certified ? why_certified(change) : why_measured(metric);
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

}  // namespace

std::vector<FigureChange> compare_figures(const StageMeasures& base, const StageMeasures& now,
                                          const Options& options) {
  const Fineness fineness = fineness_of(base, now);
  std::vector<FigureChange> out;
  for (const Metric& metric : record::stage_metrics()) {
    FigureChange change;
    change.metric = &metric;
    change.base = metric.of(base);
    change.now = metric.of(now);
    judge(change, fineness, options);
    const bool is_gouge = metric.id == "gouge_mm";
    change.where =
        deepest(change, is_gouge ? base.gouges : base.uncuts, is_gouge ? now.gouges : now.uncuts);
    out.push_back(std::move(change));
  }
  return out;
}

}  // namespace limitgauge::reports::compare
