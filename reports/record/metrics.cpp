#include "reports/record/metrics.h"

#include <algorithm>
#include <array>

#include "verifier/robust/tolerance_margin.h"

namespace limitgauge::reports::record {
namespace {

using verifier::Interval;

using Figure = std::optional<Interval>;

template <auto Member>
Figure figure(const StageMeasures& m) {
  const auto value = static_cast<double>(m.*Member);
  return Interval{value, value};
}
template <double DeviationMeasures::*Member>
Figure sampled(const StageMeasures& m) {
  if (!m.deviation) return std::nullopt;
  const double value = *m.deviation.*Member;
  return Interval{value, value};
}
template <Interval DeviationMeasures::*Member>
Figure certified(const StageMeasures& m) {
  return m.deviation ? Figure(*m.deviation.*Member) : std::nullopt;
}

template <Interval RobustMeasures::*Member>
Figure robust(const StageMeasures& m) {
  if (!m.deviation || !m.deviation->robust) return std::nullopt;
  return *m.deviation->robust.*Member;
}
Figure margin(const StageMeasures& m) {
  if (!m.deviation || !m.deviation->robust || !m.deviation->robust->margin) return std::nullopt;
  return margin_interval(*m.deviation->robust->margin);
}

using M = StageMeasures;
using D = DeviationMeasures;
using R = RobustMeasures;
constexpr std::array kMetrics = {
    Metric{"gouge_mm", "gouge", "mm", Better::lower, Source::certified, certified<&D::gouge_mm>},
    Metric{"uncut_mm", "uncut", "mm", Better::lower, Source::certified, certified<&D::uncut_mm>},
    Metric{"missing_stock_mm", "missing stock", "mm", Better::lower, Source::certified,
           certified<&D::missing_stock_mm>},
    Metric{"robust_gouge_mm", "gouge over tolerances", "mm", Better::lower, Source::certified,
           robust<&R::gouge_mm>},
    Metric{"robust_uncut_mm", "uncut over tolerances", "mm", Better::lower, Source::certified,
           robust<&R::uncut_mm>},
    Metric{"margin", "tolerance margin", "", Better::higher, Source::certified, margin},
    Metric{"coverage", "coverage", "", Better::higher, Source::measured, sampled<&D::coverage>},
    Metric{"mean_mm", "mean deviation", "mm", Better::neither, Source::measured,
           sampled<&D::mean_mm>},
    Metric{"rms_mm", "rms deviation", "mm", Better::lower, Source::measured, sampled<&D::rms_mm>},
    Metric{"p01_mm", "1st percentile", "mm", Better::less_gouge, Source::measured,
           sampled<&D::p01_mm>},
    Metric{"p50_mm", "median", "mm", Better::neither, Source::measured, sampled<&D::p50_mm>},
    Metric{"p99_mm", "99th percentile", "mm", Better::less_uncut, Source::measured,
           sampled<&D::p99_mm>},
    Metric{"voxel_gouge_mm", "gouge in the stock", "mm", Better::lower, Source::measured,
           sampled<&D::voxel_gouge_mm>},
    Metric{"voxel_uncut_mm", "uncut in the stock", "mm", Better::lower, Source::measured,
           sampled<&D::voxel_uncut_mm>},
    Metric{"unreachable_area_mm2", "area out of reach", "mm²", Better::neither, Source::measured,
           sampled<&D::unreachable_area_mm2>},
    Metric{"unavoidable_uncut_mm", "unavoidable uncut", "mm", Better::neither, Source::measured,
           sampled<&D::unavoidable_uncut_mm>},
    Metric{"removed_volume_mm3", "removed volume", "mm³", Better::neither, Source::measured,
           figure<&M::removed_volume_mm3>},
    Metric{"machining_time_s", "machining time", "s", Better::lower, Source::planned,
           figure<&M::machining_time_s>},
    Metric{"cut_length_mm", "cut length", "mm", Better::neither, Source::planned,
           figure<&M::cut_length_mm>},
    Metric{"rapid_length_mm", "rapid length", "mm", Better::neither, Source::planned,
           figure<&M::rapid_length_mm>},
    Metric{"moves", "moves", "", Better::neither, Source::planned, figure<&M::moves>},
    Metric{"seconds", "seconds to run", "s", Better::lower, Source::effort, figure<&M::seconds>},
    Metric{"peak_memory_bytes", "peak memory", "bytes", Better::lower, Source::effort,
           figure<&M::peak_memory_bytes>},
};

}  // namespace

std::span<const Metric> stage_metrics() {
  return kMetrics;
}

const Metric* find_metric(std::string_view id) {
  const auto found =
      std::find_if(kMetrics.begin(), kMetrics.end(), [&](const Metric& m) { return m.id == id; });
  return found == kMetrics.end() ? nullptr : &*found;
}

const char* name(Source source) {
  switch (source) {
    case Source::certified:
      return "certified";
    case Source::measured:
      return "measured";
    case Source::planned:
      return "planned";
    case Source::effort:
      break;
  }
  return "effort";
}

double promised(const Metric& metric, const Interval& figure) {
  return metric.better == Better::higher ? figure.low : figure.high;
}

bool is_over_tolerances(std::string_view metric) {
  return metric.starts_with("robust_") || metric == "margin";
}

Interval margin_interval(const verifier::ToleranceMargin& margin) {
  const double proven = margin.proven.value_or(0);
  return {proven, margin.refuted.value_or(std::max(proven, verifier::kLargestFactor))};
}

double machining_time_s(const RunRecord& run) {
  double sum = 0;
  for (const StageRecord& stage : run.stages)
    if (stage.measures) sum += stage.measures->machining_time_s;
  return sum;
}

const Interval& judged_gouge_mm(const DeviationMeasures& measures) {
  return measures.robust ? measures.robust->gouge_mm : measures.gouge_mm;
}

const Interval& judged_uncut_mm(const DeviationMeasures& measures) {
  return measures.robust ? measures.robust->uncut_mm : measures.uncut_mm;
}

Interval unreachable_figure(const DeviationMeasures& measures, bool is_share) {
  const verifier::StageDeviation::ProvenReach& reach = measures.reach;
  const Interval area_mm2{reach.unreachable_mm2, reach.unreachable_mm2 + reach.undecided_mm2};
  const double whole_mm2 = reach.reachable_mm2 + area_mm2.high;
  if (!is_share || !(whole_mm2 > 0)) return area_mm2;
  return {area_mm2.low / whole_mm2, area_mm2.high / whole_mm2};
}

}  // namespace limitgauge::reports::record
