#pragma once

#include "reports/compare/comparison.h"

namespace limitgauge::reports::compare {

/// How finely two runs were measured: the coarser of the two.
struct Fineness {
  double resolution_mm = 0;  ///< widest certified interval accepted; 0 without a design
  double voxel_mm = 0;       ///< of the stock
};
Fineness fineness_of(const record::StageMeasures& base, const record::StageMeasures& now);

/// Up to where a change of a metric says nothing, in the metric's unit; `base` is what was promised
/// before.
double noise_floor(const record::Metric& metric, double base, const Fineness& fineness);

/// Up to where a statistic of sampled deviations says nothing.
double sample_floor_mm(const Fineness& fineness);

/// The rule for one figure; docs/compare.md has it with its reasons. Not judged where neither way
/// is better, and for what the running took.
Judgement judge_figure(const record::Metric& metric, const verifier::Interval& base,
                       const verifier::Interval& now, const Fineness& fineness);

/// Whether the figure is a factor that is proven up to its lower end.
bool is_margin(const record::Metric& metric);

/// Whether even the least that `a` can be is more than the most that `b` can be.
bool wholly_above(const verifier::Interval& a, const verifier::Interval& b);

}  // namespace limitgauge::reports::compare
