#pragma once

#include "reports/picture/deviation_scale.h"
#include "reports/picture/image.h"

namespace limitgauge::reports {

/// Where a colour bar stands on a picture, in pixels.
struct BarFrame {
  int left = 0, top = 0, height = 0;
};
/// The bar from the full scale of gouge (bottom) to that of uncut (top), its ticks in figures; with
/// `words`, it also says which part of it is in tolerance and which beyond.
void draw_colour_bar(Image& image, const DeviationScale& scale, const BarFrame& frame,
                     bool words = false);

}  // namespace limitgauge::reports
