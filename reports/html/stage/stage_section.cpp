#include "reports/html/stage/stage_parts.h"

#include <algorithm>

#include <fmt/format.h>

#include "reports/html/charts.h"
#include "reports/html/markup.h"
#include "reports/html/stage/tolerance_parts.h"
#include "reports/picture/png.h"
#include "reports/picture/tool_side.h"
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

/// What a reader of a stage that passed need not see: all of it is folded then.
std::string measured_part(const RunResult& result, std::size_t index) {
  const StageResult& stage = result.stages[index];
  const StageRun& ran = *stage.ran;
  std::string out = plates(stage, index);
  if (ran.deviation) out += "<h3>Gouges and leftovers</h3>\n" + findings_part(result, index);
  out += "<h3>Process</h3>\n" + process_table(ran, index) + process_charts(index);
  out += program_part(result, index) + ignored_words(ran.ignored_words);
  if (ran.deviation) out += patch_table(result, index);
  out += fold("more", "More figures of the stage", figures_part(stage));
  if (ran.deviation) out += budget_table(ran.deviation->budget);
  return fold("stage-body",
              ran.deviation ? "Map, histogram, findings and process of this stage"
                            : "Stock, process and figures of this stage",
              out, stage.verdict() != verifier::Verdict::pass);
}

std::string request_line(const StageResult& stage) {
  std::vector<std::string> parts = {escape_markup(stage.tool) + ", " + cutter_text(stage.cutter),
                                    path_source(stage)};
  const bool turns = stage.ran && stage.ran->axes;
  if (!stage.setup.name.empty())
    parts.push_back("setup " + escape_markup(stage.setup.name) +
                    (turns ? "" : ", the tool comes from " + tool_side_words(stage.setup)));
  if (turns) parts.push_back("the tool turns as it goes");
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
  return fmt::format(
      "<section class=\"stage\" id=\"{}\" data-stage=\"{}\"><h2><span class=\"no\">Stage {}</span> "
      "{} {}</h2>\n<p class=\"request\">{}</p>\n{}{}</section>\n",
      stage_anchor(index), index, index + 1, escape_markup(stage.name), badge(stage.verdict()),
      request_line(stage), tolerance_part(result, index),
      stage.ran ? measured_part(result, index) : std::string());
}

}  // namespace limitgauge::reports::html
