#include "reports/html/stage/error_map.h"

#include <fmt/format.h>

#include <algorithm>

#include "reports/html/charts.h"
#include "reports/html/markup.h"
#include "reports/html/page_picture.h"
#include "reports/picture/deviation_map.h"
#include "reports/text/text.h"

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
    const PixelPoint p = frame.pixel(findings[i].place.point);
    // On the right its name stands to the left, so that narrow screens do not scroll for it.
    const char* side = 2 * p.x > frame.width ? " left" : "";
    out += fmt::format("<span class=\"marker{}\" style=\"left:{}%;top:{}%\"><i>{}{}</i></span>",
                       side, fixed(100 * p.x / frame.width, 2), fixed(100 * p.y / frame.height, 2),
                       letter, i + 1);
  }
  return out;
}

std::string map_figure(const verifier::StageDeviation& d, const DeviationScale& scale,
                       std::string_view caption) {
  const MapFrame frame = map_frame(d.field, kMapWidth, kMapHeight);
  const std::string image = png_uri(palette_png(draw_map(d.field, scale, frame)));
  const std::string hatched =
      d.unreachable_area_mm2 > 0 ? " Hatched: the cutter cannot reach there." : "";
  return fmt::format(
      "<figure class=\"map\"><figcaption>{}{} Fine lines: patch borders.</figcaption>"
      "<div class=\"frame\"><img src=\"{}\" width=\"{}\" height=\"{}\" "
      "alt=\"Map of deviation seen from +Z, X to the right, Y up\"/>{}{}</div>{}</figure>\n",
      caption, hatched, image, frame.width, frame.height, markers(d.gouges, 'G', frame),
      markers(d.uncuts, 'U', frame), colour_legend(scale));
}

bool is_faint(const verifier::StageDeviation& d, const verifier::GateLimits& l) {
  return (l.has_gouge || l.has_uncut) && (!l.has_gouge || d.gouge_mm.high < kFaint * l.gouge_mm) &&
         (!l.has_uncut || d.uncut_mm.high < kFaint * l.uncut_mm);
}

}  // namespace

std::string error_map(const StageResult& stage) {
  const verifier::StageDeviation& d = stage.ran->deviation;
  if (d.field.quads.empty()) return {};
  if (is_faint(d, stage.limits))
    return map_figure(d, DeviationScale::magnified(d),
                      "Deviation seen from +Z. All of it is far inside the limits: the colours are "
                      "scaled by what was measured.");
  return map_figure(d, DeviationScale::for_gate(d, stage.limits),
                    "Deviation seen from +Z, colours scaled by the gate limits: pale is in "
                    "tolerance, dark is beyond a limit.");
}

}  // namespace limitgauge::reports::html
