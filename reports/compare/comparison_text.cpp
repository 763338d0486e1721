#include "reports/compare/comparison_text.h"

#include <algorithm>
#include <cmath>

#include "reports/run/process.h"
#include "reports/text/text.h"

namespace limitgauge::reports::compare {
namespace {

using verifier::Interval;

constexpr double kLeastPercent = 0.01;

std::string signed_text(double value, const std::string& magnitude) {
  return (value < 0 ? "−" : "+") + magnitude;
}

std::string in_unit(double mm, const LengthUnit& unit) {
  return three_digits(mm * unit.per_mm) + " " + unit.symbol;
}

std::string interval_or_number(const Interval& figure, const LengthUnit& unit) {
  if (figure.low == figure.high) return in_unit(figure.high, unit);
  return interval_numbers(figure, unit) + " " + unit.symbol;
}

FigureText length_cells(const FigureChange& change) {
  const double largest =
      std::max({std::abs(change.base.high), std::abs(change.now.high), change.floor.value_or(0)});
  const LengthUnit unit = unit_for(largest);
  const double moved = change.now.high - change.base.high;
  return {interval_or_number(change.base, unit), interval_or_number(change.now, unit),
          moved == 0 ? "0" : signed_text(moved, measured_length(std::abs(moved))),
          change.floor ? stated_length(*change.floor) : ""};
}

FigureText share_cells(const FigureChange& change) {
  const double points = 100 * (change.now.high - change.base.high);
  return {percent_text(change.base.high), percent_text(change.now.high),
          points == 0 ? "0" : signed_text(points, three_digits(std::abs(points)) + " points"),
          change.floor ? three_digits(100 * *change.floor) + " points" : ""};
}

std::string plain(const record::Metric& metric, double value) {
  if (metric.unit == "s") return duration_text(value);
  if (metric.unit == "bytes") return bytes_text(static_cast<std::size_t>(value));
  if (metric.unit.empty()) return grouped(static_cast<std::uint64_t>(value));
  return three_digits(value) + " " + std::string(metric.unit);
}

FigureText plain_cells(const FigureChange& change) {
  const double was = change.base.high, is = change.now.high;
  std::string moved = was == is ? "0" : "";
  if (moved.empty() && was != 0) {
    const double percent = 100 * std::abs((is - was) / was);
    moved = percent < kLeastPercent ? "below 0.01 %"
                                    : signed_text(is - was, three_digits(percent) + " %");
  }
  return {plain(*change.metric, was), plain(*change.metric, is), moved,
          change.floor ? plain(*change.metric, *change.floor) : ""};
}

}  // namespace

const char* name(Judgement judgement) {
  switch (judgement) {
    case Judgement::better:
      return "better";
    case Judgement::same:
      return "same";
    case Judgement::worse:
      return "worse";
    case Judgement::not_judged:
      break;
  }
  return "not judged";
}

const char* name(const FindingChange& change) {
  const bool is_near_miss = change.kind == "near_miss";
  switch (change.status) {
    case FindingStatus::fresh:
      return "new";
    case FindingStatus::gone:
      return "vanished";
    case FindingStatus::deeper:
      return is_near_miss ? "farther" : "deeper";
    case FindingStatus::shallower:
      return is_near_miss ? "nearer" : "shallower";
    case FindingStatus::moved:
      break;
  }
  return "moved";
}

std::string kind_text(const std::string& kind) {
  if (kind == "missing_stock") return "missing stock";
  for (const simulator::FindingKind known : kFindingKinds)
    if (kind == simulator::name(known)) return description(known);
  return kind;
}

FigureText figure_text(const FigureChange& change) {
  const bool is_length = change.metric->unit == "mm";
  if (is_length && change.metric->source != record::Source::planned) return length_cells(change);
  return change.metric->id == "coverage" ? share_cells(change) : plain_cells(change);
}

std::string depth_text(const FindingChange& change) {
  if (!change.now) return change.base ? measured_length(change.base->depth_mm) + " before" : "";
  const std::string now = measured_length(change.now->depth_mm);
  return change.base ? now + ", " + measured_length(change.base->depth_mm) + " before" : now;
}

std::string line_text(const FoundPlace& place, const std::string& stage) {
  if (!place.line) return "no move";
  std::string text = "line " + std::to_string(*place.line);
  if (!place.stage.empty() && place.stage != stage) text += " of " + place.stage;
  return place.line_text.empty() ? text : text + ": " + place.line_text;
}

std::string summary(const Comparison& comparison) {
  const auto counted = [](std::size_t count, const char* one, const char* many) {
    return grouped(count) + " " + (count == 1 ? one : many);
  };
  switch (comparison.judgement()) {
    case Judgement::worse: {
      const std::string text = "worse: " + counted(comparison.worse, "regression", "regressions");
      if (comparison.better == 0) return text;
      return text + ", " + counted(comparison.better, "improvement", "improvements");
    }
    case Judgement::better:
      return "better: " + counted(comparison.better, "improvement", "improvements");
    default:
      return "same: nothing changed beyond the noise floor";
  }
}

}  // namespace limitgauge::reports::compare
