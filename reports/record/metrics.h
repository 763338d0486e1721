#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "reports/record/run_record.h"

namespace limitgauge::reports::record {

/// Which way a figure is better. `less_gouge` and `less_uncut`: signed deviations at either end of
/// their distribution, which count as far as they lie below or above zero. A mean or a median has
/// no better side: it falls with a gouge, too.
enum class Better { lower, higher, less_gouge, less_uncut, neither };

/// Where a figure comes from, and so how far it can be trusted.
enum class Source {
  certified,  ///< an interval that holds the truth
  measured,   ///< from samples of the surface or of the stock
  planned,    ///< an exact figure of the path: length, time of machining
  effort,     ///< seconds and bytes of this program: another machine, other figures
};

/// "certified" and so on.
const char* name(Source source);

/// One figure of a stage.
struct Metric {
  std::string_view id;     ///< "gouge_mm": as in result.json
  std::string_view label;  ///< "gouge"
  std::string_view unit;   ///< "mm", "s", ""
  Better better = Better::neither;
  Source source = Source::measured;
  /// The figure, as an interval of no width where it is no certified one; empty where it is of a
  /// design and the stage was measured against none, or of tolerances and none were stated.
  std::optional<verifier::Interval> (*of)(const StageMeasures&) = nullptr;
};

/// All of them, in the order in which reports list them: certified ones first.
std::span<const Metric> stage_metrics();
/// The end of the figure that a run promises: `high`, or `low` of what is better the higher it is.
double promised(const Metric& metric, const verifier::Interval& figure);
/// From the factor that is proven to the one that is refuted: the truth lies between. Where none is
/// proven it begins at 0; where none is refuted it ends with the largest that is tried.
verifier::Interval margin_interval(const verifier::ToleranceMargin& margin);
/// Figures over every value of the tolerances, and their margin: only a run with tolerances has
/// them.
bool is_over_tolerances(std::string_view metric);
/// Nothing where there is no such metric.
const Metric* find_metric(std::string_view id);

/// Sum over the stages that were run.
double machining_time_s(const RunRecord& run);

}  // namespace limitgauge::reports::record
