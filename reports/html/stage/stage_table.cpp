#include "reports/html/stage/stage_table.h"

#include <fmt/format.h>

#include "reports/html/anchors.h"
#include "reports/html/markup.h"
#include "reports/html/stage/stage_section.h"
#include "reports/run/gate_figures.h"
#include "reports/run/process.h"
#include "reports/text/text.h"

namespace limitgauge::reports::html {
namespace {

/// "71.1 to 515 mm² (3.24 to 23.5 %)" with the share on a line of its own: the row is wide.
std::string share_below(const std::string& measured) {
  const std::size_t share = measured.find(" (");
  if (share == std::string::npos) return measured;
  return measured.substr(0, share) + "<small>" + measured.substr(share + 1) + "</small>";
}

std::vector<std::string> stage_row(const StageResult& stage, std::size_t index) {
  const std::vector<GateFigure> f = gate_figures(stage);
  const auto figure = [&](std::size_t i) {
    if (f[i].standing == Standing::not_run) return std::string("–");
    return share_below(f[i].measured) +
           (f[i].limit.empty() ? "" : "<small>limit " + f[i].limit + "</small>");
  };
  const std::size_t hits = stage.ran ? faults(stage.ran->process) : 0;
  return {fmt::format("<a href=\"#{}\">{}</a>", stage_anchor(index), escape_markup(stage.name)),
          fmt::format("{}<small>{}</small>", escape_markup(stage.tool), cutter_text(stage.cutter)),
          path_source(stage),
          stated_length(stage.allowance_mm),
          figure(0),
          figure(1),
          figure(2),
          figure(3),
          stage.ran ? grouped(hits) : "–",
          stage.ran ? duration_text(stage.ran->machining_time_s) : "–",
          badge(stage.verdict())};
}

}  // namespace

std::string stage_table(const RunResult& result) {
  std::vector<std::vector<std::string>> rows;
  for (std::size_t i = 0; i < result.stages.size(); ++i)
    rows.push_back(stage_row(result.stages[i], i));
  return "<section id=\"stages\"><h2>Stages</h2>\n" +
         table(
             "Gouge and uncut are certified runs along the normals, against the stage's own "
             "allowance "
             "surface; unreachable is what no cutter used so far can touch.",
             {{"Stage"},
              {"Tool"},
              {"Path"},
              {"Allowance", true},
              {"Gouge", true},
              {"Uncut", true},
              {"Coverage", true},
              {"Unreachable", true},
              {"Process faults", true},
              {"Machining time", true},
              {"Verdict"}},
             rows) +
         "</section>\n";
}

}  // namespace limitgauge::reports::html
