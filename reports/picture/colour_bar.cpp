#include "reports/picture/colour_bar.h"

#include <cmath>
#include <string>

#include "reports/picture/lettering.h"
#include "reports/picture/lines.h"
#include "reports/text/text.h"

namespace limitgauge::reports {
namespace {

constexpr int kWidth = 44;
constexpr Rgba kInk{28, 32, 38}, kPale{92, 98, 106};
constexpr TextStyle kText{20, kInk};

void draw_tick(Image& image, double deviation_mm, bool is_limit, int left, double y) {
  draw_stroke(image, {{double(is_limit ? left : left + kWidth), y}, {left + kWidth + 10.0, y}}, 2,
              kInk);
  std::string label = deviation_mm == 0 ? "0" : deviation_mm < 0 ? "–" : "+";
  if (deviation_mm != 0) label += stated_length(std::abs(deviation_mm));
  if (is_limit) label += " limit";
  draw_text(image, label, {left + kWidth + 20.0, y + kText.height / 2}, kText);
}

/// What the two halves of a side mean, the outer one first as the bar is read from its end.
void draw_words(Image& image, const DeviationScale::Side& side, double sign,
                const BarFrame& frame) {
  if (!side.has_limit) return;
  const auto put = [&](const char* text, double position) {
    const double y = frame.top + (1 - sign * position) / 2 * frame.height;
    draw_text(image, text, {frame.left + kWidth + 20.0, y + 8}, {16, kPale});
  };
  put("beyond the limit", 0.75);
  put("in tolerance", 0.25);
}

}  // namespace

void draw_colour_bar(Image& image, const DeviationScale& scale, const BarFrame& frame, bool words) {
  for (int y = 0; y < frame.height; ++y)
    image.fill(frame.left, frame.top + y, kWidth, 1,
               scale.colour(scale.deviation_mm(1 - 2 * (y + 0.5) / frame.height)));
  const std::vector<double> ticks = scale.ticks_mm();
  for (std::size_t i = 0; i < ticks.size(); ++i) {
    const bool is_limit =
        (i == 1 && scale.gouge().has_limit) || (i == 3 && scale.uncut().has_limit);
    const double y = frame.top + (1 - scale.position(ticks[i])) / 2 * frame.height;
    draw_tick(image, ticks[i], is_limit, frame.left, y);
  }
  if (!words) return;
  draw_words(image, scale.uncut(), 1, frame);
  draw_words(image, scale.gouge(), -1, frame);
}

}  // namespace limitgauge::reports
