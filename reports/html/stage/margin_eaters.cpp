#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "reports/html/markup.h"
#include "reports/html/stage/tolerance_parts.h"
#include "reports/html/tolerance_words.h"
#include "reports/text/text.h"

namespace limitgauge::reports::html {
namespace {

/// One tolerance at the place where a figure is worst.
struct Eater {
  std::string name;
  model::Interval range_mm;
  double at_mm = 0, per_mm = 0;

  /// What half of its range is good for.
  double effect_mm() const { return std::abs(per_mm) * range_mm.width() / 2; }
};

std::vector<Eater> eaters_of(const model::Tolerances& tolerances,
                             const verifier::RobustFigure& figure) {
  std::vector<Eater> out;
  const std::vector<verifier::Tolerance> stated = stated_tolerances(tolerances);
  for (std::size_t i = 0; i < std::min(figure.at.size(), figure.sensitivity.size()); ++i) {
    const std::string& name = figure.at[i].name;
    const auto tolerance =
        std::find_if(stated.begin(), stated.end(), [&](const auto& t) { return t.name() == name; });
    if (tolerance == stated.end()) continue;
    out.push_back({name, tolerance->range_mm, figure.at[i].mm, figure.sensitivity[i].mm});
  }
  std::stable_sort(out.begin(), out.end(),
                   [](const Eater& a, const Eater& b) { return a.effect_mm() > b.effect_mm(); });
  return out;
}

std::string effect_bar(double share) {
  return fmt::format(
      "<svg class=\"interval\" viewBox=\"0 0 100 10\" preserveAspectRatio=\"none\" "
      "aria-hidden=\"true\"><rect class=\"track\" x=\"0\" y=\"3.5\" width=\"100\" height=\"3\"/>"
      "<rect class=\"inside\" x=\"0\" y=\"1.5\" width=\"{}\" height=\"7\"/></svg>",
      fixed(100 * share, 2));
}

std::string number_or_zero(double value) {
  return value == 0 ? "0" : typeset(three_digits(value));
}

std::vector<std::string> eater_row(const Eater& eater, const LengthUnit& unit, double most_mm) {
  const double effect = eater.effect_mm();
  return {escape_markup(eater.name), range_words(eater.range_mm), offset_words(eater.at_mm),
          number_or_zero(eater.per_mm),
          "<span class=\"amount\">" + number_or_zero(effect * unit.per_mm) + "</span>" +
              effect_bar(most_mm > 0 ? effect / most_mm : 0)};
}

}  // namespace

std::string eaters_table(const model::Tolerances& tolerances, const NamedFigure& named) {
  const std::vector<Eater> eaters = eaters_of(tolerances, *named.figure);
  if (!named.figure->place || eaters.empty()) return {};
  const double most_mm = eaters.front().effect_mm();
  const LengthUnit unit = unit_for(most_mm);
  std::vector<std::vector<std::string>> rows;
  for (const Eater& eater : eaters) rows.push_back(eater_row(eater, unit, most_mm));
  return table(
      fmt::format("Where {0} is worst: how much it grows with each value, and what half of the "
                  "tolerance’s range is good for at that rate, the most first.",
                  named.name),
      {{"Value"},
       {"Tolerance", true},
       {"Off by, there", true},
       {"µm per µm", true},
       {std::string("Half the range, ") + unit.symbol, true}},
      rows);
}

}  // namespace limitgauge::reports::html
