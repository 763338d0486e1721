#include "reports/html/contents.h"

#include <fmt/format.h>

#include "reports/html/anchors.h"
#include "reports/html/job/engine_section.h"
#include "reports/html/markup.h"
#include "reports/text/text.h"

namespace limitgauge::reports::html {
namespace {

std::string entry(std::string_view anchor, std::string_view text) {
  return fmt::format("<li><a href=\"#{}\">{}</a></li>", anchor, text);
}

}  // namespace

std::string contents(const RunResult& result) {
  std::string list = entry("stages", "Stages") + entry("view", "Error map in 3D");
  for (std::size_t i = 0; i < result.stages.size(); ++i)
    list +=
        entry(stage_anchor(i), fmt::format("{}. {}", i + 1, escape_markup(result.stages[i].name)));
  list += entry("surface", "Design surface");
  if (has_engine_section(result)) list += entry("toolpaths", "Toolpaths");
  list += entry("tools", "Tools") + entry("inputs", "Job and inputs") +
          entry("decision", "How it was decided");
  if (!result.assumptions.empty()) list += entry("assumptions", "Assumptions");
  return "<nav class=\"contents\" aria-label=\"Contents\"><ul>" + list + "</ul></nav>\n";
}

}  // namespace limitgauge::reports::html
