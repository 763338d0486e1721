#pragma once

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

}  // namespace limitgauge::reports
