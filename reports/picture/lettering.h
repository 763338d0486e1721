#pragma once

#include <string_view>

#include "reports/picture/image.h"
#include "reports/picture/lines.h"

namespace limitgauge::reports {

/// How a text is set.
struct TextStyle {
  double height = 16;  ///< of a capital, pixels
  Rgba colour{0, 0, 0, 255};
  bool bold = false;
  int grown = 0;  ///< pixels by which the letters are wider on all sides: a halo for other text
};

/// Sets `text` (UTF-8) with its baseline starting at `at`, on whole pixels, in the face that VTK
/// brings along, so that it looks the same on every machine. A character without a glyph becomes a
/// lozenge.
void draw_text(Image& image, std::string_view text, const model::Vec2& at, const TextStyle& style);
/// In pixels.
double text_width(std::string_view text, const TextStyle& style);
/// Whether every character of `text` can be drawn.
bool has_glyphs(std::string_view text);

}  // namespace limitgauge::reports
