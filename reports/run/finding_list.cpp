#include "reports/run/finding_list.h"

#include <array>
#include <ostream>

#include "model/text/number_text.h"
#include "reports/run/gate_figures.h"
#include "reports/run/process.h"
#include "reports/run/program_lines.h"
#include "reports/run/report.h"
#include "reports/text/text.h"

namespace limitgauge::reports {
namespace {

/// One side of the gate: gouges, leftovers or missing stock.
struct Side {
  const char* kind;
  char letter;
  const std::vector<verifier::Finding>& findings;
  const verifier::Interval& figure_mm;
  bool has_limit;
  double limit_mm;
};

/// The figure's standing decides, so that levels agree with the verdict to the last bit.
Significance significance_of(const Side& side, std::size_t i) {
  if (!side.has_limit) return Significance::informs;
  const double depth_mm = side.findings[i].depth_mm;
  switch (standing_of(side.figure_mm, side.limit_mm)) {
    case Standing::beyond:
      return i == 0 || depth_mm > side.limit_mm ? Significance::fails : Significance::within;
    case Standing::undecided:
      return i == 0 || depth_mm + side.figure_mm.width() > side.limit_mm ? Significance::undecided
                                                                         : Significance::within;
    default:
      return Significance::within;
  }
}

std::string words_of(const Side& side, const verifier::Finding& f) {
  if (side.letter == 'M') return "raw stock does not cover the surface";
  if (side.letter == 'G') return "gouge by the " + f.body;
  return f.raw_stock ? "raw stock left standing" : "material left standing";
}

ListedFinding listed(const Side& side, std::size_t i, std::size_t stage) {
  const verifier::Finding& f = side.findings[i];
  ListedFinding out;
  out.id = side.letter + std::to_string(i + 1);
  out.kind = side.kind;
  out.significance = significance_of(side, i);
  out.stage = stage, out.program_stage = f.line > 0 ? f.stage : stage;
  out.line = f.line, out.move = f.move;
  out.depth_mm = f.depth_mm, out.area_mm2 = f.area_mm2;
  out.place = f.place, out.point = f.place.point;
  out.body = f.body, out.words = words_of(side, f);
  out.passes = f.passes;
  out.about = f.extent_mm.empty() ? f.place.point : (f.extent_mm.low + f.extent_mm.high) / 2.0;
  return out;
}

/// The worst place of a figure over tolerances: what happens there for which values.
ListedFinding listed(const Side& side, const verifier::RobustFigure& figure, std::size_t stage) {
  ListedFinding out;
  out.id = std::string(1, side.letter) + "T";
  out.kind = side.kind;
  if (side.has_limit) {
    const Standing standing = standing_of(figure.figure_mm, side.limit_mm);
    out.significance = standing == Standing::beyond      ? Significance::fails
                       : standing == Standing::undecided ? Significance::undecided
                                                         : Significance::within;
  }
  out.stage = stage, out.program_stage = figure.line > 0 ? figure.stage : stage;
  out.line = figure.line, out.move = figure.move;
  out.depth_mm = figure.figure_mm.low, out.body = figure.body;
  out.place = figure.place, out.point = out.about = figure.place->point;
  const std::string with = values_text(figure.at);
  out.words = (side.letter == 'G' ? "gouge by the " + figure.body : "material left standing") +
              (with.empty() ? "" : " with " + with);
  return out;
}

std::string words_of(const simulator::FindingGroup& g) {
  std::string words = description(g.kind);
  if (!g.part.empty()) words += ": " + g.part;
  if (!g.against.empty()) words += ", " + g.against;
  if (g.count > 1)
    words += "; " + std::to_string(g.count) + " moves, lines " + std::to_string(g.first_line) +
             " to " + std::to_string(g.last_line);
  return words;
}

ListedFinding listed(const simulator::FindingGroup& g, std::size_t i, std::size_t stage,
                     const StageRun& ran) {
  ListedFinding out;
  out.id = "P" + std::to_string(i + 1);
  out.kind = simulator::name(g.kind);
  out.significance = fails(g.kind) ? Significance::fails : Significance::informs;
  out.stage = out.program_stage = stage;
  out.line = g.worst.line, out.move = g.worst.move;
  out.depth_mm = g.worst.depth_mm, out.point = g.worst.point;
  out.body = g.part, out.words = words_of(g);
  out.process = g;
  const bool has_move = ran.path && g.first_move < ran.path->moves.size();
  out.about = has_move ? ran.path->moves[g.first_move].to : g.worst.point;
  return out;
}

}  // namespace

namespace {

/// Where tolerances are stated they come first: they decide.
void add_tolerated(const verifier::StageDeviation& d, const verifier::GateLimits& l,
                   std::size_t stage, std::vector<ListedFinding>& out) {
  if (!d.robust) return;
  const verifier::RobustFigure &gouge = d.robust->gouge, &uncut = d.robust->uncut;
  if (gouge.place)
    out.push_back(
        listed({"gouge", 'G', d.gouges, gouge.figure_mm, l.has_gouge, l.gouge_mm}, gouge, stage));
  if (uncut.place)
    out.push_back(
        listed({"uncut", 'U', d.uncuts, uncut.figure_mm, l.has_uncut, l.uncut_mm}, uncut, stage));
}

void add_sides(const verifier::StageDeviation& d, const verifier::GateLimits& l, std::size_t stage,
               std::vector<ListedFinding>& out) {
  for (const Side& side :
       {Side{"gouge", 'G', d.gouges, d.gouge_mm, l.has_gouge, l.gouge_mm},
        Side{"uncut", 'U', d.uncuts, d.uncut_mm, l.has_uncut, l.uncut_mm},
        Side{"missing_stock", 'M', d.missing_stock, d.missing_stock_mm, l.has_gouge, l.gouge_mm}})
    for (std::size_t i = 0; i < side.findings.size(); ++i) out.push_back(listed(side, i, stage));
}

}  // namespace

std::vector<ListedFinding> list_findings(const RunResult& result, std::size_t index) {
  std::vector<ListedFinding> out;
  const StageResult& stage = result.stages[index];
  if (!stage.ran) return out;
  if (stage.ran->deviation) add_tolerated(*stage.ran->deviation, stage.limits, index, out);
  if (stage.ran->deviation) add_sides(*stage.ran->deviation, stage.limits, index, out);
  const std::vector<simulator::FindingGroup> groups = worst_first(stage.ran->process);
  for (std::size_t i = 0; i < groups.size(); ++i)
    out.push_back(listed(groups[i], i, index, *stage.ran));
  return out;
}

std::string values_text(const std::vector<verifier::NamedLength>& values) {
  std::string text;
  for (const verifier::NamedLength& value : values)
    if (value.mm != 0)
      text += (text.empty() ? "" : ", ") + value.name + (value.mm > 0 ? " +" : " ") +
              model::six_digits(value.mm) + " mm";
  return text;
}

std::string program_file(const StageResult& stage) {
  return stage.program.empty() ? stage.name + "/toolpath.ngc" : stage.program;
}

namespace {

constexpr std::string_view kHeader =
    "stage,kind,id,depth_mm,area_mm2,x,y,z,patch,u,v,body,program,line,move,words";

template <typename T, typename Show>
std::string optional_cell(const std::optional<T>& value, Show show) {
  return value ? std::string(show(*value)) : std::string();
}

std::string row(const RunResult& result, const ListedFinding& f) {
  using verifier::SurfacePlace;
  const auto count = [](std::uint64_t n) { return std::to_string(n); };
  const std::array cells = {
      csv_text_cell(result.stages[f.stage].name),
      csv_text_cell(f.kind),
      csv_text_cell(f.id),
      model::shortest(f.depth_mm),
      optional_cell(f.area_mm2, model::shortest),
      model::shortest(f.point.x),
      model::shortest(f.point.y),
      model::shortest(f.point.z),
      optional_cell(f.place, [](const SurfacePlace& p) { return std::to_string(p.patch); }),
      optional_cell(f.place, [](const SurfacePlace& p) { return model::shortest(p.u); }),
      optional_cell(f.place, [](const SurfacePlace& p) { return model::shortest(p.v); }),
      csv_text_cell(f.body),
      csv_text_cell(program_file(result.stages[f.program_stage])),
      f.line > 0 ? count(f.line) : std::string(),
      f.line > 0 ? count(f.move) : std::string(),
      csv_text_cell(f.words)};
  std::string out = cells[0];
  for (std::size_t i = 1; i < cells.size(); ++i) out += "," + cells[i];
  return out;
}

}  // namespace

void write_findings_csv(const RunResult& result, std::ostream& out) {
  out << kHeader << "\r\n";
  for (std::size_t i = 0; i < result.stages.size(); ++i)
    for (const ListedFinding& finding : list_findings(result, i))
      out << row(result, finding) << "\r\n";
}

}  // namespace limitgauge::reports
