#include "reports/html/stage/stage_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "reports/html/markup.h"
#include "reports/html/stage/tolerance_parts.h"
#include "reports/text/interval_text.h"

namespace limitgauge::reports::html {
namespace {

/// Of a longer list the worst are shown, of these the first few unfolded.
constexpr std::size_t kLongestList = 20, kMostOpen = 5;

std::string more_note(std::size_t total) {
  if (total <= kLongestList) return {};
  return fmt::format("<p class=\"note\">The {} worst of {}; the others are in result.json.</p>\n",
                     kLongestList, grouped(total));
}

/// Sides of the box of a cluster, rounded for reading.
std::string extent_text(const model::Box3& box) {
  if (box.empty()) return "–";
  const model::Vec3 size = box.size();
  return fixed(size.x, 2) + " × " + fixed(size.y, 2) + " × " + fixed(size.z, 2);
}

/// The program lines of the passes around a leftover, or the body that gouged.
std::string left_by(const verifier::Finding& f) {
  if (f.passes.empty()) return escape_markup(f.body);
  std::string lines;
  for (const verifier::NearPass& p : f.passes)
    if (p.line > 0) lines += (lines.empty() ? "lines " : ", ") + std::to_string(p.line);
  return lines.empty() ? "–" : lines;
}

/// What each body of the assembly does to the part; nothing to say where all is well above it.
std::string bodies_table(const RunResult& result, const verifier::StageDeviation& d) {
  if (d.bodies.size() < 2) return {};
  double largest_mm = 0;
  for (const verifier::BodyFigure& b : d.bodies) largest_mm = std::max(largest_mm, b.gouge_mm.high);
  const LengthUnit unit = unit_for(largest_mm);
  std::vector<std::vector<std::string>> rows;
  for (const verifier::BodyFigure& b : d.bodies) {
    const bool flutes = b.body == "cutter";
    rows.push_back({escape_markup(b.body),
                    flutes || b.stage >= result.stages.size()
                        ? "all so far"
                        : escape_markup(result.stages[b.stage].name),
                    typeset(interval_numbers(b.gouge_mm, unit))});
  }
  return table("Gouge by body of the assembly, certified",
               {{"Body"}, {"Stage"}, {std::string("Gouge, ") + unit.symbol, true}}, rows);
}

/// The program line, linked to where it stands in the listing below.
std::string line_link(const RunResult& result, std::size_t index, const verifier::Finding& f) {
  if (f.line == 0) return "–";
  const std::string line = std::to_string(f.line);
  const bool listed = f.stage < result.stages.size() && result.stages[f.stage].ran &&
                      result.stages[f.stage].ran->program_text;
  if (!listed) return line;
  return fmt::format("<a href=\"#{}\">{}</a>", line_anchor(index, f.stage, f.line), line);
}

/// Patch with u and v; of a mesh, the triangle.
std::string patch_text(const RunResult& result, const verifier::SurfacePlace& place) {
  if (const MeshDesign* mesh = result.mesh_design())
    return std::to_string(mesh->triangle_of(place.patch));
  return fmt::format("{}<small>{}, {}</small>", place.patch, fixed(place.u, 4), fixed(place.v, 4));
}

/// Program line and move, with the stage where it is not this one.
std::string line_cell(const RunResult& result, std::size_t index, const verifier::Finding& f) {
  std::string out = line_link(result, index, f);
  if (f.line == 0) return out;
  if (f.stage != index && f.stage < result.stages.size())
    out += " of " + escape_markup(result.stages[f.stage].name);
  return out + "<small>move " + grouped(f.move) + "</small>";
}

/// A table of one kind of finding: its letter, and what its depth is held against.
struct FindingKindTable {
  std::string_view caption;
  char letter;
  std::optional<double> limit_mm;
  LengthUnit unit = {};
};

Row finding_row(const RunResult& result, std::size_t index, const FindingKindTable& kind,
                std::size_t number, const verifier::Finding& f) {
  const std::string name = kind.letter + std::to_string(number + 1);
  const bool missing = kind.letter == 'M';
  return {
      {name, measured_number(f.depth_mm, kind.unit, kind.limit_mm), three_digits(f.area_mm2),
       extent_text(f.extent_mm), coordinates(f.place.point), patch_text(result, f.place),
       line_cell(result, index, f), missing ? "raw stock" : left_by(f)},
      // The map in the page knows gouges and leftovers.
      missing ? " id=\"" + finding_anchor(index, name) + "\"" : finding_attributes(index, name)};
}

std::vector<Column> finding_columns(const RunResult& result, const LengthUnit& unit) {
  return {{"No."},
          {std::string("Depth, ") + unit.symbol, true},
          {"Area, mm²", true},
          {"Extent, mm", true},
          {"X, Y, Z, mm", true},
          {result.mesh_design() ? "Triangle" : "Patch, u, v", true},
          {"Line", true},
          {"By"}};
}

std::string findings_table(const RunResult& result, std::size_t index,
                           const std::vector<verifier::Finding>& findings, FindingKindTable kind) {
  if (findings.empty()) return {};
  kind.unit = unit_for(std::max(findings.front().depth_mm, kind.limit_mm.value_or(0)));
  std::vector<Row> open, folded;
  for (std::size_t i = 0; i < std::min(findings.size(), kLongestList); ++i)
    (i < kMostOpen ? open : folded).push_back(finding_row(result, index, kind, i, findings[i]));
  const std::vector<Column> columns = finding_columns(result, kind.unit);
  std::string out = table(kind.caption, columns, open);
  if (!folded.empty())
    out += fold(
        "more", fmt::format("The next {}", folded.size()),
        table(fmt::format("{}, from the {}th on", kind.caption, kMostOpen + 1), columns, folded));
  return out + more_note(findings.size());
}

Row tolerated_row(const RunResult& result, std::size_t index, const char* name,
                  const std::optional<double>& limit_mm, const LengthUnit& unit,
                  const verifier::RobustFigure& f) {
  verifier::Finding by;
  by.stage = f.stage, by.move = f.move, by.line = f.line;
  return {{name, measured_number(f.figure_mm.low, unit, limit_mm), coordinates(f.place->point),
           patch_text(result, *f.place), line_cell(result, index, by),
           f.raw_stock ? "raw stock" : escape_markup(f.body), witness_words(*result.tolerances, f)},
          finding_attributes(index, name)};
}

/// Where the figures over tolerances are worst, and with which values.
std::string tolerated_table(const RunResult& result, std::size_t index,
                            const std::optional<double>& gouge_mm,
                            const std::optional<double>& uncut_mm) {
  const auto& robust = result.stages[index].ran->deviation->robust;
  if (!robust || !result.tolerances || (!robust->gouge.place && !robust->uncut.place)) return {};
  const LengthUnit unit =
      unit_for(std::max(robust->gouge.figure_mm.low, robust->uncut.figure_mm.low));
  std::vector<Row> rows;
  if (robust->gouge.place)
    rows.push_back(tolerated_row(result, index, "GT", gouge_mm, unit, robust->gouge));
  if (robust->uncut.place)
    rows.push_back(tolerated_row(result, index, "UT", uncut_mm, unit, robust->uncut));
  return table("Worst over the tolerances: gouge (GT), material left standing (UT)",
               {{"No."},
                {std::string("Depth, ") + unit.symbol, true},
                {"X, Y, Z, mm", true},
                {result.mesh_design() ? "Triangle" : "Patch, u, v", true},
                {"Line", true},
                {"By"},
                {"With"}},
               rows);
}

/// From which depth on places are listed.
std::string threshold_note(const verifier::StageDeviation& d) {
  if (d.gouges.empty() && d.uncuts.empty())
    return "<p class=\"note\">There is no gouge and no leftover to list.</p>\n";
  return fmt::format(
      "<p class=\"note\">Listed are places that are deeper than {} (gouge) or higher than {} "
      "(material left); where no place is, the worst one stands alone.{}</p>\n",
      measured_length(d.gouge_threshold_mm), measured_length(d.uncut_threshold_mm),
      d.findings_complete ? "" : " There are more than could be searched for.");
}

}  // namespace

std::string findings_part(const RunResult& result, std::size_t index) {
  const verifier::StageDeviation& d = *result.stages[index].ran->deviation;
  const verifier::GateLimits& limits = result.stages[index].limits;
  const auto stated = [](bool has, double mm) { return has ? std::optional(mm) : std::nullopt; };
  const std::optional<double> gouge_mm = stated(limits.has_gouge, limits.gouge_mm),
                              uncut_mm = stated(limits.has_uncut, limits.uncut_mm);
  return tolerated_table(result, index, gouge_mm, uncut_mm) + threshold_note(d) +
         findings_table(result, index, d.gouges, {"Gouges, deepest first", 'G', gouge_mm}) +
         findings_table(result, index, d.uncuts,
                        {"Material left standing, highest first", 'U', uncut_mm}) +
         findings_table(result, index, d.missing_stock,
                        {"Missing raw stock, deepest first", 'M', gouge_mm}) +
         bodies_table(result, d);
}

}  // namespace limitgauge::reports::html
