#include <algorithm>

#include "reports/html/job/job_sections.h"
#include "reports/html/markup.h"
#include "reports/picture/tool_side.h"
#include "reports/text/text.h"

namespace limitgauge::reports::html {
namespace {

std::string place_text(const model::Vec3& p) {
  return "(" + three_digits(p.x) + ", " + three_digits(p.y) + ", " + three_digits(p.z) + ")";
}

std::string turn_text(const model::Pose& pose) {
  const model::Turn turn = model::turn_of(pose);
  if (turn.angle_deg == 0) return "not turned";
  return three_digits(turn.angle_deg) + "° about " + place_text(turn.axis);
}

std::string stages_in(const RunResult& result, const std::string& setup) {
  std::string list;
  for (std::size_t i = 0; i < result.stages.size(); ++i) {
    const StageResult& stage = result.stages[i];
    if (stage.setup.name != setup) continue;
    list += (list.empty() ? "<a href=\"#" : ", <a href=\"#") + stage_anchor(i) + "\">" +
            escape_markup(stage.name) + "</a>";
  }
  return list.empty() ? "none" : list;
}

/// Whether a stage of the setup turns its tool as it goes.
bool turns_tool(const RunResult& result, const std::string& setup) {
  return std::ranges::any_of(result.stages, [&](const StageResult& stage) {
    return stage.setup.name == setup && stage.ran && stage.ran->axes;
  });
}

std::string tool_from(const RunResult& result, const model::Setup& setup) {
  return tool_side_words(setup) + (turns_tool(result, setup.name) ? ", or as it turns" : "");
}

}  // namespace

std::string setups_section(const RunResult& result) {
  if (result.setups.empty()) return {};
  std::vector<std::vector<std::string>> rows;
  for (const model::Setup& setup : result.setups)
    rows.push_back({escape_markup(setup.name), turn_text(setup.from_part),
                    place_text(setup.from_part.shift_mm), tool_from(result, setup),
                    stages_in(result, setup.name)});
  return "<section id=\"setups\"><h2>Setups</h2>\n" +
         table(
             "How the part is turned into the machine, right-handed about its zero; where that "
             "then "
             "lies in the frame of the setup's programs; and from where the tool comes, in the "
             "part's frame, which all places on this page are in.",
             {{"Setup"}, {"Part turned by"}, {"Part's zero, mm"}, {"Tool from"}, {"Stages"}},
             rows) +
         "</section>\n";
}

}  // namespace limitgauge::reports::html
