#pragma once

#include <vector>

#include "model/geometry/vec2.h"
#include "reports/picture/image.h"

namespace limitgauge::reports {

/// Points and lengths are in pixels, from the upper left corner, x right and y down.

/// Draws the polyline with round ends, antialiased; one point is a dot.
void draw_stroke(Image& image, const std::vector<model::Vec2>& line, double width,
                 const Rgba& colour);
void draw_ring(Image& image, const model::Vec2& centre, double radius, double width,
               const Rgba& colour);

}  // namespace limitgauge::reports
