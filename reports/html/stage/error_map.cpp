#include "reports/html/stage/stage_parts.h"

#include <algorithm>

#include <fmt/format.h>

#include "reports/html/charts.h"
#include "reports/html/markup.h"
#include "reports/picture/deviation_map.h"
#include "reports/picture/png.h"
#include "reports/picture/tool_side.h"
#include "reports/run/patch_figures.h"
#include "reports/text/interval_text.h"
#include "reports/tolerance.h"

namespace limitgauge::reports::html {
namespace {

/// Fit for half of a page on paper, and for the screen.
constexpr int kMapWidth = 900, kMapHeight = 740;
constexpr std::size_t kMarkersPerKind = 3;
/// Below this share of the limits the gate's colours show next to nothing.
constexpr double kFaint = 0.3;

std::string markers(const std::vector<verifier::Finding>& findings, char letter,
                    const MapFrame& frame) {
  std::string out;
  for (std::size_t i = 0; i < std::min(findings.size(), kMarkersPerKind); ++i) {
    const model::Vec2 p = frame.pixel(findings[i].place.point);
    // On the right its name stands to the left, so that narrow screens do not scroll for it.
    const char* side = 2 * p.x > frame.width ? " left" : "";
    out += fmt::format("<span class=\"marker{}\" style=\"left:{}%;top:{}%\"><i>{}{}</i></span>",
                       side, fixed(100 * p.x / frame.width, 2), fixed(100 * p.y / frame.height, 2),
                       letter, i + 1);
  }
  return out;
}

/// What a map is seen from, and what is to be said of the way it lies.
struct MapSide {
  std::string from, lies;
};

MapSide map_side(const model::Setup& setup) {
  if (setup.from_part == model::Pose{}) return {"+Z", "X to the right, Y up"};
  return {tool_side_words(setup), "as it lies in setup " + escape_markup(setup.name)};
}

std::string map_figure(const verifier::StageDeviation& d, const DeviationScale& scale,
                       const MapSide& side, std::string_view caption) {
  const MapFrame frame = map_frame(d.field, kMapWidth, kMapHeight);
  const std::string image = png_uri(palette_png(draw_map(d.field, scale, frame)));
  const std::string hatched =
      d.unreachable_area_mm2 > 0 ? " Hatched: the cutter cannot reach there." : "";
  return fmt::format(
      "<figure class=\"map\"><figcaption>Deviation seen from {}{}{} Fine lines: patch "
      "borders.</figcaption>"
      "<div class=\"frame\"><img src=\"{}\" width=\"{}\" height=\"{}\" "
      "alt=\"Map of deviation seen from {}, {}\"/>{}{}</div>{}</figure>\n",
      side.from, caption, hatched, image, frame.width, frame.height, side.from, side.lies,
      markers(d.gouges, 'G', frame), markers(d.uncuts, 'U', frame), colour_legend(scale));
}

bool is_faint(const verifier::StageDeviation& d, const verifier::GateLimits& l) {
  return (l.has_gouge || l.has_uncut) && (!l.has_gouge || d.gouge_mm.high < kFaint * l.gouge_mm) &&
         (!l.has_uncut || d.uncut_mm.high < kFaint * l.uncut_mm);
}

}  // namespace

std::string error_map(const StageResult& stage) {
  if (stage.ran->deviation->field.quads.empty()) return {};
  const ToolSide tool(stage);
  const verifier::StageDeviation& d = tool.deviation();
  const MapSide side = map_side(stage.setup);
  if (is_faint(d, stage.limits))
    return map_figure(d, DeviationScale::magnified(d), side,
                      ". All of it is far inside the limits: the colours are scaled by what was "
                      "measured.");
  return map_figure(d, DeviationScale::for_gate(d, stage.limits), side,
                    ", colours scaled by the gate limits: pale is in tolerance, dark is beyond a "
                    "limit.");
}

namespace {

/// Of longer tables the worst are shown.
constexpr std::size_t kMostRows = 400;

/// Of the model and the path that were planned; a program of somebody else has neither.
std::string number_of(const std::vector<int>& numbers, int patch) {
  const auto i = static_cast<std::size_t>(patch);
  return i < numbers.size() ? std::to_string(numbers[i]) : "–";
}

/// Below half a nanometre the samples' own rounding would be shown.
std::string seen_number(double mm, const LengthUnit& unit) {
  return measured_number(mm < kNoLength_mm ? 0 : mm, unit);
}

/// In which the columns of gouge and uncut stand.
struct PatchUnits {
  LengthUnit gouge, uncut;
};

PatchUnits units_of(const std::vector<PatchFigures>& patches) {
  double gouge_mm = 0, uncut_mm = 0;
  for (const PatchFigures& f : patches)
    gouge_mm = std::max(gouge_mm, f.gouge_mm), uncut_mm = std::max(uncut_mm, f.uncut_mm);
  return {unit_for(gouge_mm), unit_for(uncut_mm)};
}

std::string percent_number(double share) {
  const std::string text = percent_text(share);
  return text.substr(0, text.rfind(" %"));
}

Row patch_row(const RunResult& result, std::size_t index, const PatchFigures& f,
              const PatchUnits& units) {
  const MeshDesign* mesh = result.mesh_design();
  const std::string name = std::to_string(mesh != nullptr ? mesh->triangle_of(f.patch) : f.patch);
  return {{name, number_of(result.surface->depths, f.patch),
           number_of(result.stages[index].ran->sampling_intervals, f.patch),
           seen_number(f.gouge_mm, units.gouge), seen_number(f.uncut_mm, units.uncut),
           three_digits(f.area_mm2), percent_number(f.unreachable_share()), grouped(f.samples)},
          fmt::format(" data-stage=\"{}\" data-patch=\"{}\"", index, f.patch)};
}

std::string summary(std::size_t shown, std::size_t all, const char* patches) {
  if (shown == all) return fmt::format("All {} {}, worst first", grouped(all), patches);
  return fmt::format("The {} worst of {} {}; all are in deviation.vtp", shown, grouped(all),
                     patches);
}

}  // namespace

std::string patch_table(const RunResult& result, std::size_t index) {
  const StageResult& stage = result.stages[index];
  const bool is_mesh = result.mesh_design() != nullptr;
  const std::vector<PatchFigures> patches =
      patch_figures(stage.ran->deviation->field, stage.limits, is_mesh ? kPatchesOfTriangle : 1);
  if (patches.empty()) return {};
  const std::size_t shown = std::min(patches.size(), kMostRows);
  const PatchUnits units = units_of(patches);
  std::vector<Row> rows;
  for (std::size_t i = 0; i < shown; ++i)
    rows.push_back(patch_row(result, index, patches[i], units));
  return fold(
      "patches", summary(shown, patches.size(), is_mesh ? "triangles" : "patches"),
      table("Depth and interval: how finely the engine's model of the patch was subdivided, "
            "and how sparsely this stage's path sampled it. Gouge and uncut are the worst of "
            "the patch's samples, uncut where the cutter can reach; certified are the figures "
            "for the whole.",
            {{is_mesh ? "Triangle" : "Patch"},
             {"Depth", true},
             {"Interval", true},
             {std::string("Gouge seen, ") + units.gouge.symbol, true},
             {std::string("Uncut seen, ") + units.uncut.symbol, true},
             {"Area, mm²", true},
             {"Out of reach, %", true},
             {"Samples", true}},
            rows));
}

}  // namespace limitgauge::reports::html
