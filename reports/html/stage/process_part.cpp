#include "reports/html/stage/stage_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "reports/html/markup.h"
#include "reports/run/process.h"
#include "reports/run/program_lines.h"
#include "reports/text/interval_text.h"

namespace limitgauge::reports::html {
namespace {

std::string lines_text(const simulator::FindingGroup& group) {
  if (group.first_line == 0) return "–";
  if (group.first_line == group.last_line) return std::to_string(group.first_line);
  return std::to_string(group.first_line) + "–" + std::to_string(group.last_line);
}

/// Linked to where the line stands in the listing.
std::string line_text(std::size_t stage, std::uint32_t line, bool listed) {
  if (line == 0) return "–";
  if (!listed) return std::to_string(line);
  return fmt::format("<a href=\"#{}\">{}</a>", line_anchor(stage, stage, line), line);
}

/// "≥ 0.84" and "0.3 apart", in the unit of the column.
std::string depth_cell(const simulator::Finding& f, const LengthUnit& unit) {
  if (f.kind == simulator::FindingKind::near_miss)
    return measured_number(-f.depth_mm, unit) + " apart";
  return f.depth_mm > 0 ? "≥ " + measured_number(f.depth_mm, unit) : "–";
}

LengthUnit unit_of(const std::vector<simulator::FindingGroup>& groups, std::size_t shown) {
  double largest_mm = 0;
  for (std::size_t i = 0; i < shown; ++i)
    largest_mm = std::max(largest_mm, std::abs(groups[i].worst.depth_mm));
  return unit_for(largest_mm);
}

Row row(std::size_t stage, std::size_t index, const simulator::FindingGroup& group, bool listed,
        const LengthUnit& unit) {
  const simulator::Finding& worst = group.worst;
  std::string what = description(group.kind);
  if (!fails(group.kind)) what += " (does not fail the stage)";
  const std::string name = "P" + std::to_string(index + 1);
  return {{name, lines_text(group), what, escape_markup(group.part), escape_markup(group.against),
           depth_cell(worst, unit), coordinates(worst.point), line_text(stage, worst.line, listed),
           grouped(group.count)},
          finding_attributes(stage, name)};
}

}  // namespace

std::string process_depth(const simulator::Finding& f) {
  if (f.kind == simulator::FindingKind::near_miss) return measured_length(-f.depth_mm) + " apart";
  return f.depth_mm > 0 ? "≥ " + measured_length(f.depth_mm) : "–";
}

std::string process_charts(std::size_t stage) {
  return fmt::format("<div data-chart=\"process\" data-stage=\"{}\"></div>\n", stage);
}

std::string process_table(const StageRun& ran, std::size_t stage) {
  const std::vector<simulator::Finding>& findings = ran.process;
  if (findings.empty()) return "<p class=\"note\">The process has no fault and no near miss.</p>\n";
  const std::vector<simulator::FindingGroup> groups = worst_first(findings);
  const std::size_t shown = std::min(groups.size(), kMostGroups);
  const LengthUnit unit = unit_of(groups, shown);
  std::vector<Row> rows;
  for (std::size_t i = 0; i < shown; ++i)
    rows.push_back(row(stage, i, groups[i], ran.program_text != nullptr, unit));
  std::string out = table("Process findings; the stock is judged as it stood at that move.",
                          {{"No."},
                           {"Lines", true},
                           {"What"},
                           {"Part"},
                           {"Against"},
                           {std::string("Worst, ") + unit.symbol, true},
                           {"X, Y, Z, mm", true},
                           {"On line", true},
                           {"Moves", true}},
                          rows);
  if (groups.size() > rows.size())
    out += "<p class=\"note\">The " + std::to_string(rows.size()) + " worst of " +
           grouped(groups.size()) + "; the others are in result.json.</p>\n";
  return out;
}

std::string removal_terms(const StageRun& ran) {
  const simulator::RemovalTotals& t = ran.removal.totals;
  return "<h3>Removal</h3>" +
         terms({{"Largest removal rate", three_digits(t.largest_rate_mm3_min / 1000) + " cm³/min"},
                {"Largest axial engagement", measured_length(t.largest_axial_mm)},
                {"Largest radial engagement", measured_length(t.largest_radial_mm)},
                {"Feed moves that cut air",
                 duration_text(t.air_time_s) + ", " + three_digits(t.air_length_mm) + " mm"},
                {"Spacing of the lines that measured it", stated_length(t.spacing_mm)},
                {"The two stock models differ at ends of material by at most",
                 typeset(three_digits(ran.agreement.worst_end_mm * 1000)) + " µm"}});
}

}  // namespace limitgauge::reports::html
