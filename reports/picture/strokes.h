#pragma once

#include <string_view>
#include <vector>

#include "reports/picture/image.h"

namespace limitgauge::reports {

struct PixelPoint {
  double x = 0, y = 0;
};

/// Draws the polyline with round ends, antialiased; one point is a dot.
void draw_stroke(Image& image, const std::vector<PixelPoint>& line, double width,
                 const Rgba& colour);
void draw_ring(Image& image, const PixelPoint& centre, double radius, double width,
               const Rgba& colour);

/// How a text is set; `height` is that of a capital, in pixels.
struct TextStyle {
  double height = 16;
  Rgba colour{0, 0, 0, 255};
  double weight = 0.13;  ///< stroke width as a share of the height
};
/// Sets `text` with its baseline starting at `at`, in the stroke letters of this folder. A
/// character without a glyph is a box: see has_glyphs.
void draw_text(Image& image, std::string_view text, const PixelPoint& at, const TextStyle& style);
double text_width(std::string_view text, double height);
/// Whether every character of `text` can be drawn.
bool has_glyphs(std::string_view text);

}  // namespace limitgauge::reports
