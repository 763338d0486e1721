#include "reports/picture/marker.h"

#include <utility>

#include "reports/picture/lettering.h"

namespace limitgauge::reports {
namespace {

constexpr Rgba kInk{28, 32, 38}, kWhite{255, 255, 255}, kAxis{96, 104, 116};

}  // namespace

void draw_marker(Image& image, const model::Vec2& at, const std::string& label, double right_end) {
  for (const auto& [width, colour] : {std::pair{7.0, kWhite}, {3.0, kInk}})
    draw_ring(image, at, 16, width, colour);
  constexpr TextStyle kLabel{22, kInk};
  constexpr TextStyle kHalo{kLabel.height, kWhite, kLabel.bold, 3};
  const double width = text_width(label, kLabel);
  const bool fits = at.x + 22 + width < right_end;
  const model::Vec2 beside{fits ? at.x + 22 : at.x - 22 - width, at.y - 12};
  draw_text(image, label, beside, kHalo);
  draw_text(image, label, beside, kLabel);
}

void draw_axes(Image& image, const model::Vec3& right, const model::Vec3& up,
               const model::Vec2& origin) {
  constexpr double kLength = 46;
  const struct {
    const char* letter;
    model::Vec3 direction;
  } axes[] = {{"X", {1, 0, 0}}, {"Y", {0, 1, 0}}, {"Z", {0, 0, 1}}};
  for (const auto& axis : axes) {
    const double dx = model::dot(axis.direction, right) * kLength;
    const double dy = -model::dot(axis.direction, up) * kLength;
    draw_stroke(image, {origin, {origin.x + dx, origin.y + dy}}, 3, kAxis);
    draw_text(image, axis.letter, {origin.x + 1.28 * dx - 6, origin.y + 1.28 * dy + 9},
              {18, kAxis, true});
  }
}

}  // namespace limitgauge::reports
