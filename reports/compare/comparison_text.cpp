#include "reports/compare/comparison_text.h"

#include <algorithm>
#include <cmath>

#include "reports/compare/noise.h"
#include "reports/run/process.h"
#include "reports/text/interval_text.h"

namespace limitgauge::reports::compare {
namespace {

using verifier::Interval;

constexpr double kLeastPercent = 0.01;

std::string signed_text(double value, const std::string& magnitude) {
  return (value < 0 ? "−" : "+") + magnitude;
}

/// In the unit of its row, beside the limit of its run.
std::string interval_or_number(const Interval& figure, const LengthUnit& unit,
                               const std::optional<double>& limit_mm) {
  const std::string numbers = figure.low == figure.high
                                  ? measured_number(figure.high, unit, limit_mm)
                                  : interval_numbers(figure, unit, limit_mm);
  return numbers + " " + unit.symbol;
}

std::string title(const char* which, const RunHead& head) {
  constexpr std::size_t kWidest = 32;
  return head.name.empty() ? which : std::string(which) + ", " + shortened(head.name, kWidest);
}

FigureText length_cells(const FigureChange& change) {
  const double largest =
      std::max({std::abs(change.base.high), std::abs(change.now.high), change.floor.value_or(0)});
  const LengthUnit unit = unit_for(largest);
  const double moved = change.now.high - change.base.high;
  const std::string symbol = std::string(" ") + unit.symbol;
  return {interval_or_number(change.base, unit, change.base_limit),
          interval_or_number(change.now, unit, change.now_limit),
          moved == 0 ? "0" : signed_text(moved, measured_number(std::abs(moved), unit) + symbol),
          change.floor ? stated_number(*change.floor, unit) + symbol : ""};
}

/// From what is proven to what is refuted; the change is that of what is proven.
FigureText margin_cells(const FigureChange& change) {
  const LengthUnit plain{1, ""};
  const double moved = change.now.low - change.base.low;
  return {interval_numbers(change.base, plain), interval_numbers(change.now, plain),
          moved == 0 ? "0" : signed_text(moved, three_digits(std::abs(moved))),
          change.floor ? three_digits(*change.floor) : ""};
}

FigureText share_cells(const FigureChange& change) {
  const double points = 100 * (change.now.high - change.base.high);
  const auto text = [](double share, const std::optional<double>& least) {
    return least ? percent_beside(share, *least) : percent_text(share);
  };
  return {text(change.base.high, change.base_limit), text(change.now.high, change.now_limit),
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
  if (kind == "robust_gouge") return "gouge over tolerances";
  if (kind == "robust_uncut") return "uncut over tolerances";
  for (const simulator::FindingKind known : kFindingKinds)
    if (kind == simulator::name(known)) return description(known);
  return kind;
}

FigureText figure_text(const FigureChange& change) {
  const bool is_length = change.metric->unit == "mm";
  if (is_length && change.metric->source != record::Source::planned) return length_cells(change);
  if (is_margin(*change.metric)) return margin_cells(change);
  return change.metric->id == "coverage" ? share_cells(change) : plain_cells(change);
}

std::string base_title(const Comparison& comparison) {
  return title("base", comparison.base);
}

std::string new_title(const Comparison& comparison) {
  return title("new", comparison.now);
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

std::string at_text(const FoundPlace& place) {
  const model::Vec3& p = place.at_mm;
  return " at (" + fixed(p.x, 3) + ", " + fixed(p.y, 3) + ", " + fixed(p.z, 3) + ")";
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
      return "same: no figure changed beyond the noise floor";
  }
}

}  // namespace limitgauge::reports::compare
