#include "reports/html/stage/stage_parts.h"

#include <fmt/format.h>

#include <algorithm>

#include "reports/html/markup.h"
#include "reports/text/text.h"

namespace limitgauge::reports::html {
namespace {

constexpr std::size_t kLongestList = 20;

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
  std::vector<std::vector<std::string>> rows;
  for (const verifier::BodyFigure& b : d.bodies) {
    const bool flutes = b.body == "cutter";
    rows.push_back(
        {escape_markup(b.body),
         flutes || b.stage >= result.stages.size() ? "all so far"
                                                   : escape_markup(result.stages[b.stage].name),
         typeset(measured_length(b.gouge_mm.low)), typeset(measured_length(b.gouge_mm.high))});
  }
  return table("Gouge by body of the assembly, certified",
               {{"Body"}, {"Stage"}, {"At least", true}, {"At most", true}}, rows);
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

/// Of a mesh, the triangle.
std::string patch_text(const RunResult& result, int patch) {
  const MeshDesign* mesh = result.mesh_design();
  return mesh ? std::to_string(mesh->triangle_of(patch)) : std::to_string(patch);
}

Row finding_row(const RunResult& result, std::size_t index, const std::string& name,
                const verifier::Finding& f) {
  const std::string stage =
      f.stage < result.stages.size() ? escape_markup(result.stages[f.stage].name) : "–";
  return {{name, measured_length(f.depth_mm), three_digits(f.area_mm2) + " mm²",
           extent_text(f.extent_mm), coordinates(f.place.point), patch_text(result, f.place.patch),
           fixed(f.place.u, 4), fixed(f.place.v, 4), stage, line_link(result, index, f),
           grouped(f.move), name.front() == 'M' ? "raw stock" : left_by(f)},
          // The map in the page knows gouges and leftovers.
          name.front() == 'M' ? " id=\"" + finding_anchor(index, name) + "\""
                              : finding_attributes(index, name)};
}

std::string findings_table(const RunResult& result, std::size_t index,
                           const std::vector<verifier::Finding>& findings, std::string_view caption,
                           char letter) {
  if (findings.empty()) return {};
  std::vector<Row> rows;
  for (std::size_t i = 0; i < std::min(findings.size(), kLongestList); ++i)
    rows.push_back(finding_row(result, index, letter + std::to_string(i + 1), findings[i]));
  return table(caption,
               {{"No."},
                {"Depth", true},
                {"Area", true},
                {"Extent in mm", true},
                {"X, Y, Z in mm", true},
                {result.mesh_design() ? "Triangle" : "Patch", true},
                {"u", true},
                {"v", true},
                {"Stage"},
                {"Line", true},
                {"Move", true},
                {"By"}},
               rows) +
         more_note(findings.size());
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
  return threshold_note(d) + findings_table(result, index, d.gouges, "Gouges, deepest first", 'G') +
         findings_table(result, index, d.uncuts, "Material left standing, highest first", 'U') +
         findings_table(result, index, d.missing_stock, "Missing raw stock, deepest first", 'M') +
         bodies_table(result, d);
}

}  // namespace limitgauge::reports::html
