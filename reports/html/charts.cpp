#include "reports/html/charts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "model/text/number_text.h"
#include "reports/run/gate_figures.h"
#include "reports/text/interval_text.h"
#include "reports/tolerance.h"

namespace limitgauge::reports::html {
namespace {

/// "+12.5" with the sign spelt out; zero has none.
std::string signed_number(double value_mm, const LengthUnit& unit) {
  if (value_mm == 0) return "0";
  return (value_mm < 0 ? "−" : "+") +
         model::shortest(std::stod(three_digits(std::abs(value_mm) * unit.per_mm)));
}

/// Where values lie on a horizontal axis, in percent of its width.
struct Axis {
  double low = 0, high = 1;
  double percent(double value) const { return 100 * (value - low) / (high - low); }
};

/// A label under (or over) an axis, kept inside it at both ends.
std::string axis_label(double percent, std::string_view css, std::string_view text) {
  const double shift = std::clamp(percent, 0.0, 100.0);
  return fmt::format("<span class=\"{}\" style=\"left:{}%;transform:translateX(-{}%)\">{}</span>",
                     css, fixed(percent, 2), fixed(shift, 1), text);
}

/// Steps of 1, 2 or 5 times a power of ten, four to eight over the axis.
std::vector<double> round_ticks(const Axis& axis) {
  const double rough = (axis.high - axis.low) / 5,
               power = std::pow(10, std::floor(std::log10(rough)));
  const double step = rough / power < 1.5   ? power
                      : rough / power < 3.5 ? 2 * power
                      : rough / power < 7.5 ? 5 * power
                                            : 10 * power;
  std::vector<double> ticks;
  for (double k = std::ceil(axis.low / step); k * step <= axis.high; ++k) ticks.push_back(k * step);
  return ticks;
}

/// The axis takes in a limit that is near what was measured, so that the data stay visible.
Axis histogram_axis(const verifier::Histogram& h, const verifier::GateLimits& limits) {
  Axis axis{std::min(h.edges_mm.front(), 0.0), std::max(h.edges_mm.back(), 0.0)};
  const double reach = 1.6 * (axis.high - axis.low);
  if (limits.has_gouge && limits.gouge_mm <= reach) axis.low = std::min(axis.low, -limits.gouge_mm);
  if (limits.has_uncut && limits.uncut_mm <= reach)
    axis.high = std::max(axis.high, limits.uncut_mm);
  const double margin = 0.03 * (axis.high - axis.low);
  axis.low -= margin, axis.high += margin;
  return axis;
}

const char* bin_class(double low, double high, const verifier::GateLimits& limits) {
  const double middle = (low + high) / 2;
  if (limits.has_gouge && middle < -limits.gouge_mm) return "gouge";
  if (limits.has_uncut && middle > limits.uncut_mm) return "uncut";
  return "inside";
}

std::string histogram_bars(const verifier::Histogram& h, const Axis& axis,
                           const verifier::GateLimits& limits) {
  const double most = *std::max_element(h.area_mm2.begin(), h.area_mm2.end());
  std::string out;
  for (std::size_t i = 0; i < h.area_mm2.size(); ++i) {
    if (h.area_mm2[i] <= 0 || most <= 0) continue;
    // A bin that holds anything at all must be seen.
    const double height = std::max(0.8, 96 * h.area_mm2[i] / most);
    const double left = axis.percent(h.edges_mm[i]), right = axis.percent(h.edges_mm[i + 1]);
    out += fmt::format("<rect class=\"{}\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/>",
                       bin_class(h.edges_mm[i], h.edges_mm[i + 1], limits), fixed(left, 3),
                       fixed(100 - height, 3), fixed(std::max(right - left, 0.05), 3),
                       fixed(height, 3));
  }
  return out;
}

std::string vertical_line(double percent, std::string_view css) {
  return fmt::format("<line class=\"{0}\" x1=\"{1}\" x2=\"{1}\" y1=\"0\" y2=\"100\"/>", css,
                     fixed(percent, 3));
}

struct LimitMark {
  bool stated = false;
  double at_mm = 0;
  const char* name = "";
  const char* css = "";  ///< of the label
};

/// The limits' lines inside the axis and their labels, or an arrow at the side where they lie.
void add_limits(const Axis& axis, const verifier::GateLimits& limits, std::string& lines,
                std::string& labels) {
  const LimitMark marks[] = {
      {limits.has_gouge, -limits.gouge_mm, "gouge limit", "limit below-zero"},
      {limits.has_uncut, limits.uncut_mm, "uncut limit", "limit"}};
  for (const LimitMark& m : marks) {
    if (!m.stated) continue;
    const double at = axis.percent(m.at_mm);
    const std::string text = fmt::format("{} {}", m.name, stated_length(std::abs(m.at_mm)));
    if (at >= 0 && at <= 100) {
      lines += vertical_line(at, "limit");
      labels += axis_label(at, m.css, text);
    } else {
      labels += axis_label(at < 0 ? 0 : 100, m.css, at < 0 ? "← " + text : text + " →");
    }
  }
}

std::string css_colour(const Rgba& c) {
  return fmt::format("rgb({},{},{})", c.r, c.g, c.b);
}

}  // namespace

std::string interval_chart(const verifier::Interval& interval_mm, bool has_limit, double limit_mm) {
  const double largest = std::max({interval_mm.high, has_limit ? limit_mm : 0.0, kLeastExtent_mm});
  const Axis axis{0, largest * 1.15};
  const double low = axis.percent(interval_mm.low), high = axis.percent(interval_mm.high);
  std::string out =
      "<svg class=\"interval\" viewBox=\"0 0 100 10\" preserveAspectRatio=\"none\" "
      "aria-hidden=\"true\">";
  out += "<rect class=\"track\" x=\"0\" y=\"3.5\" width=\"100\" height=\"3\"/>";
  if (has_limit)
    out += fmt::format("<rect class=\"allowed\" x=\"0\" y=\"3.5\" width=\"{}\" height=\"3\"/>",
                       fixed(axis.percent(limit_mm), 3));
  const Standing standing = has_limit ? standing_of(interval_mm, limit_mm) : Standing::no_limit;
  const char* css = standing == Standing::within      ? "pass"
                    : standing == Standing::beyond    ? "fail"
                    : standing == Standing::undecided ? "open"
                                                      : "none";
  out += fmt::format("<rect class=\"{}\" x=\"{}\" y=\"1.5\" width=\"{}\" height=\"7\"/>", css,
                     fixed(low, 3), fixed(std::max(high - low, 0.7), 3));
  if (has_limit)
    out += fmt::format("<line class=\"limit\" x1=\"{0}\" x2=\"{0}\" y1=\"0\" y2=\"10\"/>",
                       fixed(axis.percent(limit_mm), 3));
  return out + "</svg>";
}

std::string histogram_chart(const verifier::StageDeviation& d, const verifier::GateLimits& limits,
                            std::size_t stage) {
  const verifier::Histogram& h = d.histogram;
  if (h.area_mm2.empty() || h.edges_mm.size() != h.area_mm2.size() + 1) return {};
  const Axis axis = histogram_axis(h, limits);
  const LengthUnit unit = unit_for(std::max(-axis.low, axis.high));
  std::string lines = vertical_line(axis.percent(0), "zero"), limit_labels, ticks;
  add_limits(axis, limits, lines, limit_labels);
  for (const double t : round_ticks(axis)) {
    const bool is_zero = std::abs(t) < kRounding * (axis.high - axis.low);
    ticks += axis_label(axis.percent(t), "tick", signed_number(is_zero ? 0 : t, unit));
  }
  return fmt::format(
      "<figure class=\"histogram\" data-stage=\"{}\"><figcaption>Area in mm² (upwards) by "
      "deviation "
      "from the allowance surface in {}: left of zero the cutter went too deep, right of it "
      "material "
      "still stands.</figcaption>"
      "<div class=\"static\"><div class=\"above\">{}</div><svg viewBox=\"0 0 100 100\" "
      "preserveAspectRatio=\"none\" "
      "role=\"img\" aria-label=\"Histogram of deviation, area-weighted\">{}{}</svg>"
      "<div class=\"below\">{}</div></div></figure>\n",
      stage, unit.symbol, limit_labels, histogram_bars(h, axis, limits), lines, ticks);
}

std::string colour_legend(const DeviationScale& scale) {
  // Each half of a side is linear in colour: two stops at the limit make the jump.
  std::string stops;
  constexpr int kSteps = 80;
  for (int i = 0; i < kSteps; ++i) {
    const double t = -1 + 2 * (i + 0.5) / kSteps;
    stops += fmt::format("<rect x=\"{}\" y=\"0\" width=\"1.02\" height=\"1\" fill=\"{}\"/>", i,
                         css_colour(scale.colour(scale.deviation_mm(t))));
  }
  std::string labels;
  const std::vector<double> ticks = scale.ticks_mm();
  double largest_mm = 0;
  for (const double tick : ticks) largest_mm = std::max(largest_mm, std::abs(tick));
  const LengthUnit unit = unit_for(largest_mm);
  for (std::size_t i = 0; i < ticks.size(); ++i) {
    const bool limit = (i == 1 && scale.gouge().has_limit) || (i == 3 && scale.uncut().has_limit);
    std::string text = ticks[i] == 0 ? "0" : ticks[i] < 0 ? "−" : "+";
    if (ticks[i] != 0) text += stated_number(std::abs(ticks[i]), unit);
    if (limit) text += "<br/>limit";
    labels += axis_label(50 + 50 * scale.position(ticks[i]), limit ? "tick limit" : "tick", text);
  }
  return fmt::format(
      "<div class=\"legend\"><div class=\"ends\"><span>too deep (gouge), {2}</span>"
      "<span>still standing (uncut), {2}</span></div><svg viewBox=\"0 0 {0} 1\" "
      "preserveAspectRatio=\"none\" aria-hidden=\"true\">{1}</svg><div "
      "class=\"below\">{3}</div></div>\n",
      kSteps, stops, unit.symbol, labels);
}

}  // namespace limitgauge::reports::html
