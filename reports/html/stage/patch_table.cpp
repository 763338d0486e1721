#include "reports/html/stage/patch_table.h"

#include <fmt/format.h>

#include <algorithm>

#include "reports/html/markup.h"
#include "reports/run/patch_figures.h"
#include "reports/text/text.h"

namespace limitgauge::reports::html {
namespace {

/// Longer tables are folded away; of still longer ones the worst are shown.
constexpr std::size_t kMostOpenPatches = 40, kMostRows = 400;

/// Of the model and the path that were planned; a program of somebody else has neither.
std::string number_of(const std::vector<int>& numbers, int patch) {
  const auto i = static_cast<std::size_t>(patch);
  return i < numbers.size() ? std::to_string(numbers[i]) : "–";
}

/// Below a nanometre the samples' own rounding would be shown.
std::string seen_length(double mm) {
  constexpr double kNothing_mm = 5e-7;
  return measured_length(mm < kNothing_mm ? 0 : mm);
}

Row patch_row(const RunResult& result, std::size_t index, const PatchFigures& f) {
  return {{std::to_string(f.patch), number_of(result.surface.depths, f.patch),
           number_of(result.stages[index].ran->sampling_intervals, f.patch),
           seen_length(f.gouge_mm), seen_length(f.uncut_mm), three_digits(f.area_mm2) + " mm²",
           percent_text(f.unreachable_share()), grouped(f.samples)},
          fmt::format(" data-stage=\"{}\" data-patch=\"{}\"", index, f.patch)};
}

std::string summary(std::size_t shown, std::size_t all) {
  if (shown == all) return fmt::format("All {} patches, worst first", grouped(all));
  return fmt::format("The {} worst of {} patches; all are in deviation.vtp", shown, grouped(all));
}

}  // namespace

std::string patch_table(const RunResult& result, std::size_t index) {
  const StageResult& stage = result.stages[index];
  const std::vector<PatchFigures> patches = patch_figures(stage.ran->deviation.field, stage.limits);
  if (patches.empty()) return {};
  const std::size_t shown = std::min(patches.size(), kMostRows);
  std::vector<Row> rows;
  for (std::size_t i = 0; i < shown; ++i) rows.push_back(patch_row(result, index, patches[i]));
  return fmt::format(
      "<details class=\"patches\"{}><summary>{}</summary>\n{}</details>\n",
      patches.size() <= kMostOpenPatches ? " open=\"\"" : "", summary(shown, patches.size()),
      table(
          "Depth and interval: how finely the engine's model of the patch was subdivided, and how "
          "sparsely this stage's path sampled it. Gouge and uncut are the worst of the patch's "
          "samples, uncut where the cutter can reach; certified are the figures for the whole.",
          {{"Patch"},
           {"Depth", true},
           {"Interval", true},
           {"Gouge seen", true},
           {"Uncut seen", true},
           {"Area", true},
           {"Out of reach", true},
           {"Samples", true}},
          rows));
}

}  // namespace limitgauge::reports::html
