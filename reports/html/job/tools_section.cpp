#include <fmt/format.h>

#include <algorithm>

#include "model/text/number_text.h"
#include "reports/html/job/job_sections.h"
#include "reports/html/markup.h"
#include "reports/text/interval_text.h"

namespace limitgauge::reports::html {
namespace {

/// A cutter and the stages that it is used in.
struct Tool {
  const StageResult* first = nullptr;
  std::string stages;
};

std::string stage_link(const RunResult& result, std::size_t index) {
  return fmt::format("<a href=\"#{}\">{}</a>", stage_anchor(index),
                     escape_markup(result.stages[index].name));
}

std::vector<Tool> tools_of(const RunResult& result) {
  std::vector<Tool> tools;
  for (std::size_t i = 0; i < result.stages.size(); ++i) {
    const StageResult& stage = result.stages[i];
    const auto known = std::find_if(tools.begin(), tools.end(), [&](const Tool& tool) {
      return tool.first->tool == stage.tool && to_text(tool.first->cutter) == to_text(stage.cutter);
    });
    if (known == tools.end()) {
      tools.push_back({&stage, stage_link(result, i)});
    } else {
      known->stages += ", " + stage_link(result, i);
    }
  }
  return tools;
}

std::string length_or_none(double mm) {
  return mm > 0 ? stated_number(mm, {}) : "–";
}

std::string degrees_or_none(double deg) {
  return deg != 0 ? typeset(model::shortest(deg)) : "–";
}

/// "⌀6 × 30", from the tip up.
std::string parts_text(const std::vector<model::CylinderPart>& parts) {
  std::string out;
  for (const model::CylinderPart& part : parts)
    out += fmt::format("{}<span class=\"part\">⌀{} × {}</span>", out.empty() ? "" : ", ",
                       model::shortest(part.diameter_mm), model::shortest(part.length_mm));
  return out.empty() ? "–" : out;
}

std::vector<std::string> tool_row(const Tool& tool) {
  const model::Cutter& c = tool.first->cutter;
  return {escape_markup(tool.first->tool),
          model::name(c.type),
          stated_number(c.diameter_mm, {}),
          length_or_none(c.corner_radius_mm),
          degrees_or_none(c.taper_angle_deg),
          degrees_or_none(c.tip_angle_deg),
          stated_number(c.flute_length_mm, {}),
          parts_text(c.shank),
          parts_text(c.holder),
          degrees_or_none(c.steepest_descent_deg),
          tool.stages};
}

}  // namespace

std::string tools_section(const RunResult& result) {
  std::vector<std::vector<std::string>> rows;
  for (const Tool& tool : tools_of(result)) rows.push_back(tool_row(tool));
  return "<section id=\"tools\"><h2>Tools</h2>\n" +
         table(
             "Shank and holder from the tip up, each part diameter × length. Steepest descent: "
             "how a feed move may go down into material, from level.",
             {{"Tool"},
              {"Type"},
              {"Diameter, mm", true},
              {"Corner radius, mm", true},
              {"Taper angle, °", true},
              {"Tip angle, °", true},
              {"Flute length, mm", true},
              {"Shank, mm"},
              {"Holder, mm"},
              {"Steepest descent, °", true},
              {"Stages"}},
             rows) +
         "</section>\n";
}

}  // namespace limitgauge::reports::html
