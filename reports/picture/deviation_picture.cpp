#include <algorithm>
#include <cmath>
#include <string>

#include "model/text/number_text.h"
#include "reports/picture/colour_bar.h"
#include "reports/picture/deviation_map.h"
#include "reports/picture/lettering.h"
#include "reports/picture/marker.h"
#include "reports/text/text.h"

namespace limitgauge::reports {
namespace {

constexpr Rgba kInk{28, 32, 38}, kWhite{255, 255, 255};
constexpr int kMargin = 36;
constexpr int kLegendWidth = 330;
constexpr int kFooter = 120;
constexpr TextStyle kText{20, kInk};

/// A length of 1, 2 or 5 times a power of ten, about a fifth of the map.
void draw_scale(Image& image, const MapFrame& frame, const model::Vec2& at) {
  const double fifth_mm = frame.width / frame.pixels_per_mm / 5;
  const double power = std::pow(10, std::floor(std::log10(fifth_mm)));
  const double length_mm = fifth_mm >= 5 * power   ? 5 * power
                           : fifth_mm >= 2 * power ? 2 * power
                                                   : power;
  const double end = at.x + length_mm * frame.pixels_per_mm;
  draw_stroke(image, {{at.x, at.y - 8}, at, {end, at.y}, {end, at.y - 8}}, 2.5, kInk);
  draw_text(image, model::shortest(length_mm) + " mm", {end + 14, at.y + 2}, kText);
}

void draw_worst(Image& image, const std::vector<verifier::Finding>& findings, const MapFrame& frame,
                const char* letter, const std::string& words, const model::Vec2& note) {
  if (findings.empty()) return;
  const model::Vec2 p = frame.pixel(findings.front().place.point);
  draw_marker(image, {p.x + kMargin, p.y + kMargin}, letter, image.width());
  draw_text(
      image,
      std::string(letter) + ": worst " + words + " " + measured_length(findings.front().depth_mm),
      note, kText);
}

}  // namespace

Image draw_deviation_picture(const verifier::StageDeviation& d,
                             const verifier::GateLimits& limits) {
  const MapFrame frame = map_frame(d.field, 1400, 1100);
  const DeviationScale scale = DeviationScale::for_gate(d, limits);
  const int body = std::max(frame.height, 520);
  Image image(frame.width + 2 * kMargin + kLegendWidth, body + 2 * kMargin + kFooter, kWhite);
  image.draw(draw_map(d.field, scale, frame), kMargin, kMargin);
  const int bar_left = frame.width + 2 * kMargin;
  draw_text(image, "uncut", {double(bar_left), kMargin + 20.0}, kText);
  draw_colour_bar(image, scale, {bar_left, kMargin + 46, body - 92});
  draw_text(image, "gouge", {double(bar_left), kMargin + body - 10.0}, kText);
  const double foot = body + 2 * kMargin + 30;
  draw_scale(image, frame, {kMargin + 4.0, foot});
  draw_worst(image, d.gouges, frame, "G", "gouge", {kMargin + 4.0, foot + 56});
  draw_worst(image, d.uncuts, frame, "U", "uncut", {kMargin + 420.0, foot + 56});
  if (d.unreachable_area_mm2 > 0) {
    draw_hatch(image, kMargin + 840, int(foot) + 32, 28);
    draw_text(image, "not reachable", {kMargin + 880.0, foot + 56}, kText);
  }
  return image;
}

}  // namespace limitgauge::reports
