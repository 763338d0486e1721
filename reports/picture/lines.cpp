#include "reports/picture/lines.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "model/geometry/segment.h"

namespace limitgauge::reports {

void draw_stroke(Image& image, const std::vector<model::Vec2>& line, double width,
                 const Rgba& colour) {
  const auto [left, right] = std::minmax_element(
      line.begin(), line.end(), [](const auto& a, const auto& b) { return a.x < b.x; });
  const auto [top, bottom] = std::minmax_element(
      line.begin(), line.end(), [](const auto& a, const auto& b) { return a.y < b.y; });
  for (int y = int(std::floor(top->y - width)); y <= int(bottom->y + width); ++y) {
    for (int x = int(std::floor(left->x - width)); x <= int(right->x + width); ++x) {
      const model::Vec2 p{x + 0.5, y + 0.5};
      double d = model::distance(p, line[0]);
      for (std::size_t i = 0; i + 1 < line.size(); ++i)
        d = std::min(d, model::distance_to_segment(p, line[i], line[i + 1]));
      const double coverage = width / 2 - d + 0.5;
      if (coverage > 0) image.blend(x, y, colour, coverage);
    }
  }
}

void draw_ring(Image& image, const model::Vec2& centre, double radius, double width,
               const Rgba& colour) {
  std::vector<model::Vec2> circle;
  constexpr int kCorners = 48;
  for (int i = 0; i <= kCorners; ++i) {
    const double angle = 2 * std::numbers::pi * i / kCorners;
    circle.push_back({centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle)});
  }
  draw_stroke(image, circle, width, colour);
}

}  // namespace limitgauge::reports
