#include "reports/compare/noise.h"

#include <algorithm>
#include <cmath>

#include "reports/tolerance.h"
#include "verifier/tolerance.h"

namespace limitgauge::reports::compare {
namespace {

using record::Better;
using record::Metric;
using record::Source;
using verifier::Interval;

/// Samples on the rim of a limit change sides on rounding alone.
constexpr double kCoverageFloor = 0.001;
/// Lengths and times of a path are exact but for the digits of its program.
constexpr double kPlannedFloor = 0.001;

/// Samples are exact: what is left is what matters, a hundredth of the gate where the resolution is
/// a tenth of it.
constexpr double kSampleShare = 0.1;

/// The search for a margin ends where what is proven and what is refuted are that near to each
/// other, as a share of them.
constexpr double kMarginFloor = 0.001;

Judgement by_floor(double harm, double floor) {
  if (harm > floor) return Judgement::worse;
  return harm < -floor ? Judgement::better : Judgement::same;
}

/// The figure as a number that is better the lower it is.
double badness(const Metric& metric, double value) {
  switch (metric.better) {
    case Better::higher:
      return -value;
    case Better::less_gouge:
      return std::max(-value, 0.0);
    case Better::less_uncut:
      return std::max(value, 0.0);
    default:
      return value;
  }
}

}  // namespace

bool is_margin(const Metric& metric) {
  return metric.source == Source::certified && metric.better == Better::higher;
}

bool wholly_above(const Interval& a, const Interval& b) {
  return a.low > b.high + kSameLength_mm;
}

Fineness fineness_of(const record::StageMeasures& base, const record::StageMeasures& now) {
  const auto resolution_mm = [](const record::StageMeasures& m) {
    return m.deviation ? m.deviation->resolution_mm : 0;
  };
  return {std::max(resolution_mm(base), resolution_mm(now)), std::max(base.voxel_mm, now.voxel_mm)};
}

double sample_floor_mm(const Fineness& fineness) {
  return std::max(kSampleShare * fineness.resolution_mm, kSameLength_mm);
}

double noise_floor(const Metric& metric, double base, const Fineness& fineness) {
  if (metric.source == Source::planned) return kPlannedFloor * std::abs(base);
  if (is_margin(metric)) return kMarginFloor * std::abs(base);
  if (metric.id == "coverage") return kCoverageFloor;
  if (metric.id.starts_with("voxel_")) return std::max(fineness.voxel_mm, kSameLength_mm);
  if (metric.source == Source::certified) return std::max(fineness.resolution_mm, kSameLength_mm);
  return sample_floor_mm(fineness);
}

namespace {

/// What lies between proven and refuted is not known, so that margins whose intervals meet may be
/// alike. Neither width nor end says more: where nothing is refuted the end is only that of the
/// search.
Judgement judge_margin(const Interval& base, const Interval& now, double floor) {
  if (now.high < base.low && base.low - now.low > floor) return Judgement::worse;
  if (now.low > base.high && now.low - base.low > floor) return Judgement::better;
  return Judgement::same;
}

/// Beyond the resolution an interval may be wide where its figure is beyond its limit: up to a
/// share of it. What is wider was not narrowed as was asked for, and shows.
double settled_width_mm(const Interval& figure) {
  return std::min(figure.width(), verifier::kSettledShare * figure.low + kSameLength_mm);
}

}  // namespace

/// The truth of either run may lie anywhere in its interval, so bounds alone say little: a change
/// is one where the intervals do not meet, or where the upper end, which is what a run promises,
/// moved by more than an interval may be wide. An unchanged truth cannot do either, as long as both
/// runs reached their resolution; a run that did not promises less, and that shows here.
Judgement judge_figure(const Metric& metric, const Interval& base, const Interval& now,
                       const Fineness& fineness) {
  if (metric.better == Better::neither || metric.source == Source::effort)
    return Judgement::not_judged;
  const double floor = noise_floor(metric, record::promised(metric, base), fineness);
  if (is_margin(metric)) return judge_margin(base, now, floor);
  const double harm = badness(metric, now.high) - badness(metric, base.high);
  if (metric.source != Source::certified) return by_floor(harm, floor);
  if (wholly_above(now, base)) return Judgement::worse;
  if (wholly_above(base, now)) return Judgement::better;
  return by_floor(harm, std::max({floor, settled_width_mm(base), settled_width_mm(now)}));
}

}  // namespace limitgauge::reports::compare
