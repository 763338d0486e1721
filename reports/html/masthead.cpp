#include "reports/html/masthead.h"

#include <fmt/format.h>

#include "reports/html/headline.h"
#include "reports/html/job/job_sections.h"
#include "reports/html/markup.h"
#include "reports/html/stage/stage_parts.h"
#include "reports/html/tolerance_line.h"
#include "reports/text/text.h"

namespace limitgauge::reports::html {
namespace {

std::string design_text(const SurfaceResult& surface) {
  const std::string file = escape_markup(surface.cage);
  if (!surface.mesh) return file + ", a Catmull-Clark cage: its limit surface";
  return fmt::format("{}, a mesh: its {} facets as they are", file, grouped(surface.summary.faces));
}

}  // namespace

std::string masthead(const RunResult& result) {
  return fmt::format(
             "<header><p class=\"kind\">Limitgauge · {}</p>"
             "<h1>{}</h1>\n<div class=\"verdict {}\"><p class=\"word\">{}</p>\n{}{}{}{}{}</div>\n",
             result.surface ? "certificate of toolpath verification"
                            : "a program cut without a design",
             escape_markup(result.job), css_class(result.verdict), badge(result.verdict),
             verdict_lines(result), worst_places(result), placeless_reasons(result),
             notes_list(result), tolerance_line(result)) +
         terms(
             {{"Created", escape_markup(result.created)},
              {"Design surface", result.surface ? design_text(*result.surface)
                                                : "none: gouge, uncut and coverage are not known"},
              {"Stock", stock_text(result.raw_stock)},
              {"Program version", "limitgauge " + escape_markup(result.version)}}) +
         "</header>\n";
}

namespace {

std::string entry(std::string_view anchor, std::string_view text) {
  return fmt::format("<li><a href=\"#{}\">{}</a></li>", anchor, text);
}

}  // namespace

std::string contents(const RunResult& result) {
  std::string list = entry("stages", "Stages") +
                     entry("view", result.surface ? "Error map in 3D" : "Finished stock in 3D");
  for (std::size_t i = 0; i < result.stages.size(); ++i)
    list +=
        entry(stage_anchor(i), fmt::format("{}. {}", i + 1, escape_markup(result.stages[i].name)));
  if (result.surface) list += entry("surface", "Design surface");
  if (has_engine_section(result)) list += entry("toolpaths", "Toolpaths");
  if (!result.setups.empty()) list += entry("setups", "Setups");
  list += entry("tools", "Tools") + entry("inputs", "Job and inputs") +
          entry("decision", "How it was decided");
  if (!result.assumptions.empty()) list += entry("assumptions", "Assumptions");
  return "<nav class=\"contents\" aria-label=\"Contents\"><ul>" + list + "</ul></nav>\n";
}

}  // namespace limitgauge::reports::html
