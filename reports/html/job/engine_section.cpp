#include "reports/html/job/job_sections.h"

#include <fmt/format.h>

#include <algorithm>

#include "reports/html/markup.h"
#include "reports/html/stage/stage_parts.h"
#include "reports/text/text.h"

namespace limitgauge::reports::html {
namespace {

using Cells = std::vector<std::string>;

const std::string kNothing = "–";

std::string span_text(int low, int high) {
  return low == high ? std::to_string(low) : fmt::format("{} to {}", low, high);
}

std::string span_text(const std::optional<std::pair<int, int>>& span) {
  return span ? span_text(span->first, span->second) : kNothing;
}

std::string count_text(const std::optional<int>& count) {
  return count ? grouped(static_cast<std::uint64_t>(std::max(*count, 0))) : kNothing;
}

std::string seconds_text(const std::optional<double>& seconds) {
  return seconds ? three_digits(*seconds) : kNothing;
}

/// Published in units of a million bytes, as this page's own figures are.
std::string megabytes_text(const std::optional<double>& mb) {
  return mb ? three_digits(*mb) : kNothing;
}

std::string megabytes_text(std::size_t bytes) {
  return three_digits(static_cast<double>(bytes) / 1e6);
}

std::string model_table(const RunResult& result) {
  const SurfaceResult& s = *result.surface;
  std::vector<Cells> rows = {{"this run", grouped(std::uint64_t(s.summary.patches)),
                              span_text(s.depth_min, s.depth_max),
                              span_text(s.sampling_interval_min, s.sampling_interval_max),
                              three_digits(s.seconds), megabytes_text(s.memory_bytes)}};
  if (s.cell_bytes_counted > 0)
    rows.push_back({"its CELL control points in single precision, as the paper counts them", "", "",
                    "", "", megabytes_text(s.cell_bytes_counted)});
  if (const auto& p = result.published)
    rows.push_back({"published", count_text(p->patches), span_text(p->depth),
                    span_text(p->sampling_interval), seconds_text(p->seconds),
                    megabytes_text(p->memory_mb)});
  return table("Model of the surface",
               {{"Whose figures"},
                {"Patches", true},
                {"Subdivision depth", true},
                {"Sampling interval", true},
                {"Time, s", true},
                {"Memory, MB", true}},
               rows);
}

Cells path_row(const StageResult& stage, const StageRun& r) {
  return {escape_markup(stage.name),
          grouped(std::uint64_t(std::max(r.planes, 0))),
          span_text(r.sampling_interval_min, r.sampling_interval_max),
          grouped(r.path ? r.path->moves.size() : 0),
          three_digits(r.plan_seconds),
          megabytes_text(r.path_memory_bytes)};
}

Cells published_row(const PublishedFigures::Stage& stage) {
  return {escape_markup(stage.name) + "<small>published</small>",
          count_text(stage.planes),
          kNothing,
          kNothing,
          seconds_text(stage.seconds),
          megabytes_text(stage.memory_mb)};
}

std::string path_table(const RunResult& result) {
  std::vector<Cells> rows;
  for (const StageResult& stage : result.stages) {
    if (!stage.ran) continue;
    rows.push_back(path_row(stage, *stage.ran));
    if (!result.published) continue;
    for (const PublishedFigures::Stage& published : result.published->stages)
      if (published.name == stage.name) rows.push_back(published_row(published));
  }
  return table("Toolpaths",
               {{"Stage"},
                {"Planes or levels", true},
                {"Sampling interval", true},
                {"Moves", true},
                {"Planned in, s", true},
                {"Memory, MB", true}},
               rows);
}

}  // namespace

bool has_engine_section(const RunResult& result) {
  return std::any_of(result.stages.begin(), result.stages.end(),
                     [](const StageResult& s) { return s.ran.has_value(); });
}

std::string engine_section(const RunResult& result) {
  const bool planned = std::any_of(result.stages.begin(), result.stages.end(),
                                   [](const StageResult& s) { return s.ran && s.program.empty(); });
  if (!has_engine_section(result)) return {};
  const std::string paths = path_table(result);
  std::string source;
  if (result.published)
    source = "<p class=\"note\">Published: " + escape_markup(result.published->source) + "</p>\n";
  return "<section id=\"toolpaths\"><h2>Toolpaths</h2>\n" +
         (planned ? model_table(result) : std::string()) + paths + source + "</section>\n";
}

}  // namespace limitgauge::reports::html
