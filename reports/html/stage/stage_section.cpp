#include "reports/html/stage/stage_parts.h"

#include <algorithm>

#include <fmt/format.h>

#include "reports/html/charts.h"
#include "reports/html/markup.h"
#include "reports/picture/png.h"
#include "reports/run/gate_figures.h"
#include "reports/run/process.h"
#include "reports/text/text.h"

namespace limitgauge::reports::html {
namespace {

constexpr std::size_t kMostWords = 20;

std::string ignored_words(const std::vector<std::string>& words) {
  if (words.empty()) return {};
  std::string list;
  for (std::size_t i = 0; i < std::min(words.size(), kMostWords); ++i)
    list += (i ? ", " : "") + escape_markup(words[i]);
  return fmt::format(
      "<p class=\"note\">Words that move nothing; of these only tools and the spindle are heeded "
      "(line: "
      "word): "
      "{}{}.</p>\n",
      list, words.size() > kMostWords ? " …" : "");
}

std::string stock_figure(const std::optional<StagePictures>& pictures) {
  if (!pictures || pictures->stock_png.empty()) return {};
  return fmt::format(
      "<figure class=\"stock\"><figcaption>The stock after this stage, as simulated."
      "</figcaption><img src=\"{}\" alt=\"Shaded view of the cut stock\"/></figure>\n",
      png_uri(palette_png(read_png(pictures->stock_png))));
}

std::string plates(const StageResult& stage, std::size_t index) {
  std::string out = "<div class=\"plates\">";
  if (stage.pictures && stage.ran->deviation) out += error_map(stage);
  out += stock_figure(stage.pictures);
  if (stage.ran->deviation) out += histogram_chart(*stage.ran->deviation, stage.limits, index);
  return out + "</div>\n";
}

std::string measured_part(const RunResult& result, std::size_t index) {
  const StageResult& stage = result.stages[index];
  const StageResult::Ran& ran = *stage.ran;
  std::string out = gate_part(stage) + plates(stage, index);
  if (ran.deviation) out += "<h3>Gouges and leftovers</h3>\n" + findings_part(result, index);
  out += "<h3>Process</h3>\n" + process_table(ran, index) + process_charts(index);
  out += program_part(result, index);
  if (ran.deviation) out += "<h3>Patches</h3>\n" + patch_table(result, index);
  out += figures_part(ran) + ignored_words(ran.ignored_words);
  return ran.deviation ? out + "<h3>Uncertainty</h3>\n" + budget_table(ran.deviation->budget) : out;
}

std::string request_line(const StageResult& stage) {
  std::vector<std::string> parts = {escape_markup(stage.tool) + ", " + cutter_text(stage.cutter),
                                    path_source(stage)};
  if (stage.step_mm > 0) parts.push_back("path interval " + stated_length(stage.step_mm));
  if (stage.allowance_mm) parts.push_back("allowance " + stated_length(*stage.allowance_mm));
  if (stage.tolerance_mm > 0)
    parts.push_back("path tolerance " + stated_length(stage.tolerance_mm));
  std::string out;
  for (const std::string& part : parts)
    out += fmt::format("{}<span class=\"part\">{}</span>", out.empty() ? "" : " · ", part);
  return out;
}

}  // namespace

std::string path_source(const StageResult& stage) {
  return stage.program.empty()
             ? escape_markup(stage.strategy)
             : "program " + escape_markup(stage.program) +
                   (stage.program_part.empty() ? "" : ", ") + escape_markup(stage.program_part);
}

std::string cutter_text(const model::Cutter& cutter) {
  return fmt::format("{} ⌀{}", model::name(cutter.type), stated_length(cutter.diameter_mm));
}

std::string stage_section(const RunResult& result, std::size_t index) {
  const StageResult& stage = result.stages[index];
  std::string reasons;
  for (const std::string& reason : stage.decision.reasons)
    reasons += "<li>" + escape_markup(reason) + "</li>";
  if (!reasons.empty()) reasons = fmt::format("<ul class=\"reasons\">{}</ul>", reasons);
  return fmt::format(
      "<section class=\"stage\" id=\"{}\" data-stage=\"{}\"><h2><span class=\"no\">Stage {}</span> "
      "{} "
      "{}</h2>\n<p class=\"request\">{}</p>\n{}\n{}</section>\n",
      stage_anchor(index), index, index + 1, escape_markup(stage.name), badge(stage.verdict()),
      request_line(stage), reasons, stage.ran ? measured_part(result, index) : std::string());
}

namespace {

/// "71.1 to 515 mm² (3.24 to 23.5 %)" with the share on a line of its own: the row is wide.
std::string share_below(const std::string& measured) {
  const std::size_t share = measured.find(" (");
  if (share == std::string::npos) return measured;
  return measured.substr(0, share) + "<small>" + measured.substr(share + 1) + "</small>";
}

/// What stands in a row whether there is a design or not.
std::vector<std::string> first_cells(const StageResult& stage, std::size_t index) {
  return {fmt::format("<a href=\"#{}\">{}</a>", stage_anchor(index), escape_markup(stage.name)),
          badge(stage.verdict()),
          fmt::format("{}<small>{}</small><small>{}</small>", escape_markup(stage.tool),
                      cutter_text(stage.cutter), path_source(stage))};
}

std::string process_faults_cell(const StageResult& stage) {
  return stage.ran ? grouped(faults(stage.ran->process)) : "–";
}

std::string machining_time_cell(const StageResult& stage) {
  return stage.ran ? duration_text(stage.ran->machining_time_s) : "–";
}

std::vector<std::string> cut_row(const StageResult& stage, std::size_t index) {
  std::vector<std::string> cells = first_cells(stage, index);
  cells.push_back(stage.ran ? three_digits(stage.ran->removed_volume_mm3 / 1000) + " cm³" : "–");
  cells.push_back(process_faults_cell(stage));
  cells.push_back(machining_time_cell(stage));
  return cells;
}

std::vector<std::string> stage_row(const StageResult& stage, std::size_t index) {
  const std::vector<GateFigure> f = gate_figures(stage);
  const auto figure = [&](std::size_t i) {
    if (f[i].standing == Standing::not_run) return std::string("–");
    return share_below(f[i].measured) +
           (f[i].limit.empty() ? "" : "<small>limit " + f[i].limit + "</small>");
  };
  std::vector<std::string> cells = first_cells(stage, index);
  cells.push_back(stage.allowance_mm ? stated_length(*stage.allowance_mm) : "–");
  for (const std::size_t i : {0, 1, 2, 3}) cells.push_back(figure(i));
  cells.push_back(process_faults_cell(stage));
  cells.push_back(machining_time_cell(stage));
  return cells;
}

std::string cut_table(const RunResult& result) {
  std::vector<std::vector<std::string>> rows;
  for (std::size_t i = 0; i < result.stages.size(); ++i)
    rows.push_back(cut_row(result.stages[i], i));
  return table("What was cut, without a design to measure it against.",
               {{"Stage"},
                {"Verdict"},
                {"Tool, path"},
                {"Removed volume", true},
                {"Process faults", true},
                {"Machining time", true}},
               rows);
}

}  // namespace

std::string stage_table(const RunResult& result) {
  if (!result.surface)
    return "<section id=\"stages\"><h2>Stages</h2>\n" + cut_table(result) + "</section>\n";
  std::vector<std::vector<std::string>> rows;
  for (std::size_t i = 0; i < result.stages.size(); ++i)
    rows.push_back(stage_row(result.stages[i], i));
  return "<section id=\"stages\"><h2>Stages</h2>\n" +
         table(
             "Gouge and uncut are certified runs along the normals, against the stage's own "
             "allowance "
             "surface; unreachable is what no cutter used so far can touch.",
             {{"Stage"},
              {"Verdict"},
              {"Tool, path"},
              {"Allowance", true},
              {"Gouge", true},
              {"Uncut", true},
              {"Coverage", true},
              {"Unreachable", true},
              {"Process faults", true},
              {"Machining time", true}},
             rows) +
         "</section>\n";
}

}  // namespace limitgauge::reports::html
