#include <fmt/format.h>

#include <algorithm>

#include "reports/html/markup.h"
#include "reports/html/stage/tolerance_parts.h"
#include "reports/run/gate_figures.h"
#include "reports/text/interval_text.h"
#include "verifier/gate/verify.h"

namespace limitgauge::reports::html {
namespace {

/// Gouge or uncut, without tolerances and over all their values.
struct Compared {
  const char *name, *title;
  verifier::Interval stated_mm;
  const verifier::RobustFigure& robust;
  std::optional<double> limit_mm;
};

std::vector<Compared> compared(const StageResult& stage) {
  const verifier::StageDeviation& d = *stage.ran->deviation;
  const verifier::GateLimits& l = stage.limits;
  const auto limit = [](bool has, double mm) { return has ? std::optional(mm) : std::nullopt; };
  return {{"gouge", "Gouge", d.gouge_mm, d.robust->gouge, limit(l.has_gouge, l.gouge_mm)},
          {"uncut", "Uncut", d.uncut_mm, d.robust->uncut, limit(l.has_uncut, l.uncut_mm)}};
}

std::string standing_cell(const verifier::Interval& interval_mm, const Compared& c,
                          const LengthUnit& unit) {
  const Standing standing = c.limit_mm ? standing_of(interval_mm, *c.limit_mm) : Standing::no_limit;
  return interval_numbers(interval_mm, unit, c.limit_mm) + "\u00a0" + unit.symbol + "<small>" +
         badge(standing) + "</small>";
}

std::vector<std::string> compared_row(const Compared& c) {
  const LengthUnit unit =
      unit_for(std::max({c.stated_mm.high, c.robust.figure_mm.high, c.limit_mm.value_or(0.0)}));
  std::string all = standing_cell(c.robust.figure_mm, c, unit);
  if (!c.robust.reached_resolution) all += "<small>wider than asked for</small>";
  return {c.title, standing_cell(c.stated_mm, c, unit), all,
          c.limit_mm ? stated_number(*c.limit_mm, unit) + " " + unit.symbol : "–"};
}

std::string compared_table(const std::vector<Compared>& figures) {
  std::vector<std::vector<std::string>> rows;
  for (const Compared& c : figures) rows.push_back(compared_row(c));
  return table(
      "Gouge and uncut of the stated tools and zero, and for all values that the tolerances allow: "
      "some of them reach the lower end, none exceed the upper one.",
      {{"Figure"}, {"As stated", true}, {"All tolerances", true}, {"Limit", true}}, rows);
}

/// What the simulated stock says of it.
std::string reading_words(const verifier::RobustFigure& figure) {
  if (!figure.voxel_mm) return {};
  return " The simulated stock, cut with these values, reads " + measured_length(*figure.voxel_mm) +
         " there.";
}

std::string witness_item(const model::Tolerances& tolerances, const Compared& c) {
  if (!c.robust.place)
    return fmt::format("<li><strong>{}:</strong> no values are known that lead to any.</li>\n",
                       c.title);
  const model::Vec3& p = c.robust.place->point;
  return fmt::format(
      "<li><strong>Worst {}</strong> that is known, at X {}, Y {}, Z {} mm: with {}.{}</li>\n",
      c.name, typeset(fixed(p.x, 3)), typeset(fixed(p.y, 3)), typeset(fixed(p.z, 3)),
      witness_words(tolerances, c.robust), reading_words(c.robust));
}

std::vector<NamedFigure> tightest_first(const std::vector<Compared>& figures,
                                        const verifier::RobustDeviation& robust) {
  const verifier::RobustFigure* least = verifier::least_margin(robust);
  std::vector<NamedFigure> out;
  for (const Compared& c : figures) out.push_back({c.name, &c.robust});
  if (out.back().figure == least) std::swap(out.front(), out.back());
  return out;
}

/// The first that there is is open.
std::string eaters(const model::Tolerances& tolerances, const std::vector<NamedFigure>& figures) {
  std::string out;
  for (const NamedFigure& named : figures) {
    const std::string rows = eaters_table(tolerances, named);
    if (rows.empty()) continue;
    const std::string name = named.name;
    out += fold(
        "eaters",
        named.figure->margin ? "What eats the margin of " + name : "What " + name + " depends on",
        rows, out.empty());
  }
  return out;
}

}  // namespace

std::string tolerance_part(const RunResult& result, std::size_t index) {
  const StageResult& stage = result.stages[index];
  if (!result.tolerances || !stage.ran || !stage.ran->deviation || !stage.ran->deviation->robust)
    return {};
  const std::vector<Compared> figures = compared(stage);
  std::string out =
      "<h3>Tolerances</h3>\n<div class=\"compared\">" + compared_table(figures) + "</div>\n<ul>";
  for (const Compared& c : figures) out += witness_item(*result.tolerances, c);
  const std::vector<NamedFigure> ordered = tightest_first(figures, *stage.ran->deviation->robust);
  return out + "</ul>\n" + margin_chart(ordered) + eaters(*result.tolerances, ordered);
}

}  // namespace limitgauge::reports::html
