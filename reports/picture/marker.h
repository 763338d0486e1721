#pragma once

#include <string>

#include "model/geometry/vec3.h"
#include "reports/picture/lines.h"

namespace limitgauge::reports {

/// A ring about a place with its name beside it, legible on any ground; left of it where it would
/// reach beyond `right_end`.
void draw_marker(Image& image, const model::Vec2& at, const std::string& label, double right_end);
/// The axes X, Y, Z as seen by a viewer for whom `right` and `up` lead right and up in their frame.
void draw_axes(Image& image, const model::Vec3& right, const model::Vec3& up,
               const model::Vec2& origin);

}  // namespace limitgauge::reports
