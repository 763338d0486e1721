#include "reports/html/stage/stage_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "reports/html/markup.h"
#include "reports/html/stage/tolerance_parts.h"
#include "reports/run/finding_list.h"
#include "reports/run/gate_figures.h"
#include "reports/run/process.h"
#include "reports/run/program_lines.h"
#include "reports/text/interval_text.h"

namespace limitgauge::reports::html {
namespace {

using Samples = std::vector<verifier::DeviationField::Sample>;

/// Gouge or uncut, with what differs between the two.
struct Side {
  const char* title;
  char letter;
  std::size_t figure;  ///< index in gate_figures
  double sign;         ///< of the deviation
};
constexpr Side kGouge{"Worst gouge", 'G', 0, -1}, kUncut{"Most material left", 'U', 1, +1};

std::string axes(const model::Vec3& p) {
  return fmt::format(
      "<span class=\"part\">X {}</span>, <span class=\"part\">Y {}</span>, "
      "<span class=\"part\">Z {} mm</span>",
      typeset(fixed(p.x, 3)), typeset(fixed(p.y, 3)), typeset(fixed(p.z, 3)));
}

std::string place_text(const RunResult& result, const verifier::SurfacePlace& place) {
  if (const auto* mesh = result.mesh_design())
    return axes(place.point) + fmt::format(" · <span class=\"part\">triangle {}</span>",
                                           mesh->triangle_of(place.patch));
  return axes(place.point) + fmt::format(" · <span class=\"part\">patch {}, u {}, v {}</span>",
                                         place.patch, fixed(place.u, 4), fixed(place.v, 4));
}

/// "412 of rough/toolpath.ngc" and what stands on it.
std::string line_text(const RunResult& result, std::size_t stage, std::uint32_t line) {
  if (stage >= result.stages.size()) return {};
  const StageResult& cut = result.stages[stage];
  std::string out =
      fmt::format("<strong>line {}</strong> of {}", line, escape_markup(program_file(cut)));
  if (!cut.ran || !cut.ran->program_text) return out;
  for (const ProgramLine& text : program_lines(*cut.ran->program_text, {{line}}, 0))
    out += "<br/><code>" + escape_markup(text.text) + "</code>";
  return out;
}

std::string card(const std::string& title, const std::string& measure,
                 const std::vector<Term>& list, const std::string& more = {}) {
  return fmt::format(
      "<div class=\"worst\"><p class=\"what\">{} <strong>{}</strong>{}</p>{}</div>\n", title,
      measure, more, terms(list));
}

/// ", limit 10 µm: beyond"; the interval stands in the table of stages.
std::string beside_limit(const GateFigure& figure) {
  if (figure.limit.empty()) return ", not limited";
  return ", limit " + figure.limit + ": " + name(figure.standing);
}

std::string depth_beside(double mm, const GateFigure& figure) {
  return measured_beside(mm, figure.length ? figure.length->limit_mm : std::nullopt);
}

/// Of the listed finding.
std::string finding_card(const RunResult& result, std::size_t index, const Side& side,
                         const GateFigure& figure, const verifier::Finding& f) {
  std::vector<Term> list = {{"Where", place_text(result, f.place)}};
  if (f.line > 0) {
    list.push_back(
        {side.letter == 'G' ? "Program" : "Nearest pass", line_text(result, f.stage, f.line)});
  } else if (f.raw_stock) {
    list.push_back({"Nearest", "a face of the raw stock"});
  }
  if (!f.body.empty() && f.body != "cutter") list.push_back({"By", escape_markup(f.body)});
  const std::string id = side.letter + std::string("1");
  list.push_back(
      {"More",
       finding_link(index, id, id + " of stage " + escape_markup(result.stages[index].name))});
  return card(side.title, depth_beside(f.depth_mm, figure), list, beside_limit(figure));
}

/// The sample that is worst on one side; where nothing is proven beyond a limit there may be no
/// finding to name.
const verifier::DeviationField::Sample* worst_sample(const Samples& samples, const Side& side) {
  const verifier::DeviationField::Sample* worst = nullptr;
  for (const verifier::DeviationField::Sample& s : samples) {
    if (side.sign > 0 && !s.reachable) continue;
    if (!worst || side.sign * s.deviation_mm > side.sign * worst->deviation_mm) worst = &s;
  }
  return worst && side.sign * worst->deviation_mm > 0 ? worst : nullptr;
}

std::string sample_card(const RunResult& result, std::size_t index, const Side& side,
                        const GateFigure& figure) {
  const auto* s = worst_sample(result.stages[index].ran->deviation->field.samples, side);
  if (!s) return card(side.title, figure.measured, {}, beside_limit(figure));
  std::vector<Term> list = {{"Where", place_text(result, s->place)}};
  if (s->line > 0) list.push_back({"Nearest pass", line_text(result, s->stage, s->line)});
  return card(std::string(side.title) + ", of the samples",
              depth_beside(side.sign * s->deviation_mm, figure), list, beside_limit(figure));
}

/// Of a figure that only other values of the tolerances than those stated bring beyond its limit;
/// the findings are of those stated.
std::string tolerance_card(const RunResult& result, std::size_t index, const Side& side,
                           const GateFigure& figure, const verifier::RobustFigure& robust) {
  const std::string id = side.letter + std::string("T");
  return card(
      std::string(side.title) + " over the tolerances", figure.measured,
      {{"Where", place_text(result, *robust.place)},
       {"With", witness_words(*result.tolerances, robust)},
       {"More",
        finding_link(index, id, id + " of stage " + escape_markup(result.stages[index].name))}},
      beside_limit(figure));
}

/// Whether the figure is one that keeps the stage from passing; too small a coverage speaks of what
/// is not limited by itself.
bool is_to_blame(const std::vector<GateFigure>& figures, const Side& side) {
  const Standing standing = figures[side.figure].standing;
  if (standing == Standing::beyond || standing == Standing::undecided) return true;
  return standing == Standing::no_limit && figures[2].standing == Standing::beyond;
}

/// Whether it takes tolerances to come to that.
bool is_by_tolerances(const verifier::StageDeviation& d, const Side& side,
                      const GateFigure& figure) {
  if (!d.robust || !figure.length || !figure.length->limit_mm) return false;
  const bool gouge = side.letter == 'G';
  return (gouge ? d.robust->gouge : d.robust->uncut).place &&
         standing_of(gouge ? d.gouge_mm : d.uncut_mm, *figure.length->limit_mm) != figure.standing;
}

std::string side_card(const RunResult& result, std::size_t index, const Side& side) {
  const std::vector<GateFigure> figures = gate_figures(result.stages[index]);
  if (!is_to_blame(figures, side)) return {};
  const verifier::StageDeviation& d = *result.stages[index].ran->deviation;
  const std::vector<verifier::Finding>& findings = side.letter == 'G' ? d.gouges : d.uncuts;
  const GateFigure& figure = figures[side.figure];
  if (is_by_tolerances(d, side, figure))
    return tolerance_card(result, index, side, figure,
                          side.letter == 'G' ? d.robust->gouge : d.robust->uncut);
  return findings.empty() ? sample_card(result, index, side, figure)
                          : finding_card(result, index, side, figure, findings.front());
}

/// Where the raw stock does not cover the surface, if that keeps the stage from passing.
std::string stock_card(const RunResult& result, std::size_t index) {
  const std::vector<verifier::Finding>& findings =
      result.stages[index].ran->deviation->missing_stock;
  for (const GateFigure& figure : gate_figures(result.stages[index])) {
    const bool blamed =
        figure.standing == Standing::beyond || figure.standing == Standing::undecided;
    if (figure.name != "missing stock" || !blamed || findings.empty()) continue;
    return card("Missing raw stock", depth_beside(findings.front().depth_mm, figure),
                {{"Where", place_text(result, findings.front().place)}}, beside_limit(figure));
  }
  return {};
}

/// The worst of one kind; `number` is that of its row.
std::string process_card(const RunResult& result, std::size_t index, std::size_t number,
                         const simulator::Finding& f) {
  std::vector<Term> list = {
      {"Where", axes(f.point)},
      {"Bodies", escape_markup(f.part) + " against " + escape_markup(f.against)}};
  if (f.line > 0) list.push_back({"Program", line_text(result, index, f.line)});
  const std::string id = "P" + std::to_string(number + 1);
  if (number < kMostGroups)
    list.push_back(
        {"More",
         finding_link(index, id, id + " of stage " + escape_markup(result.stages[index].name))});
  std::string what = description(f.kind);
  what.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(what.front())));
  return card(what, f.depth_mm > 0 ? process_depth(f) : "", list);
}

/// One card for each kind of fault.
std::string process_cards(const RunResult& result, std::size_t index) {
  const std::vector<simulator::FindingGroup> groups =
      worst_first(result.stages[index].ran->process);
  std::vector<simulator::FindingKind> shown;
  std::string out;
  for (std::size_t i = 0; i < groups.size(); ++i) {
    const simulator::Finding& f = groups[i].worst;
    if (!fails(f.kind) || std::find(shown.begin(), shown.end(), f.kind) != shown.end()) continue;
    shown.push_back(f.kind);
    out += process_card(result, index, i, f);
  }
  return out;
}

}  // namespace

std::string worst_places(const RunResult& result) {
  std::string cards;
  for (std::size_t i = 0; i < result.stages.size(); ++i) {
    const StageResult& stage = result.stages[i];
    if (!stage.ran || stage.verdict() == verifier::Verdict::pass) continue;
    if (stage.ran->deviation)
      cards += side_card(result, i, kGouge) + side_card(result, i, kUncut) + stock_card(result, i);
    cards += process_cards(result, i);
  }
  return cards.empty() ? cards : "<div class=\"cards\">" + cards + "</div>\n";
}

}  // namespace limitgauge::reports::html
