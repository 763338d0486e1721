#include <algorithm>
#include <cmath>
#include <string>

#include "reports/picture/deviation_map.h"
#include "reports/text.h"

namespace limitgauge::reports {
namespace {

constexpr Rgba kInk{28, 32, 38}, kWhite{255, 255, 255};
constexpr int kMargin = 36;
constexpr int kLegendWidth = 330;
constexpr int kFooter = 120;
constexpr TextStyle kText{20, kInk};

void draw_marker(Image& image, const PixelPoint& at, const char* letter) {
  for (const auto& [width, colour] : {std::pair{7.0, kWhite}, {3.0, kInk}})
    draw_ring(image, at, 16, width, colour);
  const PixelPoint label{at.x + 22, at.y - 12};
  draw_text(image, letter, label, {22, kWhite, 0.4});
  draw_text(image, letter, label, {22, kInk, 0.16});
}

void draw_bar_tick(Image& image, double deviation_mm, bool is_limit, int left, int width,
                   const PixelPoint& at) {
  draw_stroke(image, {{double(is_limit ? left : left + width), at.y}, {left + width + 10.0, at.y}},
              2, kInk);
  std::string label = deviation_mm == 0 ? "0" : deviation_mm < 0 ? "–" : "+";
  if (deviation_mm != 0) label += stated_length(std::abs(deviation_mm));
  if (is_limit) label += " limit";
  draw_text(image, label, {left + width + 20.0, at.y + kText.height / 2}, kText);
}

/// The bar from the full scale of gouge (bottom) to that of uncut (top).
void draw_bar(Image& image, const DeviationScale& scale, int left, int top, int height) {
  constexpr int kWidth = 44;
  for (int y = 0; y < height; ++y)
    image.fill(left, top + y, kWidth, 1,
               scale.colour(scale.deviation_mm(1 - 2 * (y + 0.5) / height)));
  const std::vector<double> ticks = scale.ticks_mm();
  for (std::size_t i = 0; i < ticks.size(); ++i) {
    const bool is_limit =
        (i == 1 && scale.gouge().has_limit) || (i == 3 && scale.uncut().has_limit);
    const double y = top + (1 - scale.position(ticks[i])) / 2 * height;
    draw_bar_tick(image, ticks[i], is_limit, left, kWidth, {0, y});
  }
}

/// A length of 1, 2 or 5 times a power of ten, about a fifth of the map.
void draw_scale(Image& image, const MapFrame& frame, const PixelPoint& at) {
  const double fifth_mm = frame.width / frame.pixels_per_mm / 5;
  const double power = std::pow(10, std::floor(std::log10(fifth_mm)));
  const double length_mm = fifth_mm >= 5 * power   ? 5 * power
                           : fifth_mm >= 2 * power ? 2 * power
                                                   : power;
  const double end = at.x + length_mm * frame.pixels_per_mm;
  draw_stroke(image, {{at.x, at.y - 8}, at, {end, at.y}, {end, at.y - 8}}, 2.5, kInk);
  draw_text(image, shortest(length_mm) + " mm", {end + 14, at.y + 2}, kText);
}

void draw_worst(Image& image, const std::vector<verifier::Finding>& findings, const MapFrame& frame,
                const char* letter, const std::string& words, const PixelPoint& note) {
  if (findings.empty()) return;
  const PixelPoint p = frame.pixel(findings.front().place.point);
  draw_marker(image, {p.x + kMargin, p.y + kMargin}, letter);
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
  draw_bar(image, scale, bar_left, kMargin + 46, body - 92);
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
