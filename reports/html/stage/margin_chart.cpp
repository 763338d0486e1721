#include <fmt/format.h>

#include <cmath>
#include <string_view>

#include "model/text/rounded.h"
#include "reports/html/stage/tolerance_parts.h"
#include "reports/text/text.h"
#include "verifier/robust/tolerance_margin.h"

namespace limitgauge::reports::html {
namespace {

using verifier::ToleranceMargin;

/// Where a factor lies, in percent of the scale: 1 in the middle, as far from 2 as from a half.
double place_of(double factor) {
  return 100 * factor / (1 + factor);
}

std::string span(std::string_view css, double from, double to, double height) {
  if (to <= from) return {};
  return fmt::format("<rect class=\"{}\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/>", css,
                     fixed(from, 3), fixed(5 - height / 2, 1), fixed(to - from, 3),
                     fixed(height, 1));
}

/// What passes is thick, what fails is thin: colour says it again.
std::string margin_bar(const ToleranceMargin& margin) {
  const bool is_largest = margin.proven && *margin.proven >= verifier::kLargestFactor;
  const double pass = is_largest ? 100 : place_of(margin.proven.value_or(0));
  const double fail = margin.refuted ? place_of(*margin.refuted) : 100;
  return fmt::format(
      "<svg viewBox=\"0 0 100 10\" preserveAspectRatio=\"none\" aria-hidden=\"true\">{}{}{}<line "
      "class=\"limit\" x1=\"50\" x2=\"50\" y1=\"0\" y2=\"10\"/></svg>",
      span("pass", 0, pass, 7), span("open", pass, fail, 4), span("fail", fail, 100, 1.5));
}

std::string scale() {
  struct Tick {
    double factor;
    const char* text;
  };
  constexpr Tick kTicks[] = {{0, "0"}, {0.5, "½"}, {1, "1"}, {2, "2"}, {5, "5"}, {20, "20"}};
  std::string out;
  for (const Tick& tick : kTicks) {
    const std::string at = fixed(place_of(tick.factor), 2);
    out += fmt::format(
        "<span class=\"{0}\" style=\"left:{1}%;transform:translateX(-{1}%)\">{2}</span>",
        tick.factor == 1 ? "tick limit" : "tick", at, tick.text);
  }
  return "<div class=\"below\" aria-hidden=\"true\">" + out + "</div>";
}

std::string refuted_words(const ToleranceMargin& margin) {
  if (!margin.refuted) return "; that they fail is proven for no larger factor that was tried";
  return "; from " + model::factor_text(*margin.refuted, model::Rounding::up) +
         " times on they are proven to fail";
}

}  // namespace

std::string margin_words(const ToleranceMargin& margin) {
  if (!margin.proven)
    return std::string("not even the stated values alone are proven to pass") +
           (margin.refuted ? refuted_words(margin) : "");
  if (*margin.proven >= verifier::kLargestFactor)
    return fmt::format("the tolerances may grow {} times or more (none larger was tried)",
                       verifier::kLargestFactor);
  if (*margin.proven == 0)
    return "the stated values alone are proven to pass" + refuted_words(margin);
  return fmt::format("the tolerances are proven to pass up to {} times",
                     model::factor_text(*margin.proven, model::Rounding::down)) +
         refuted_words(margin);
}

std::string margin_chart(const std::vector<NamedFigure>& figures) {
  std::string bars;
  for (const auto& [name, figure] : figures)
    if (figure->margin)
      bars += fmt::format("<p><strong>Margin of {}:</strong> {}.</p>{}\n", name,
                          margin_words(*figure->margin), margin_bar(*figure->margin));
  if (bars.empty()) return bars;
  return "<figure class=\"margins\"><figcaption>By what factor all tolerances may grow together "
         "until the limit no longer holds; 1 are those stated. Thick: proven to pass; medium: "
         "undecided; thin: proven to fail.</figcaption>\n" +
         bars + scale() + "</figure>\n";
}

}  // namespace limitgauge::reports::html
