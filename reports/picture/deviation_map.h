#pragma once

#include <cstddef>
#include <functional>

#include "reports/picture/deviation_scale.h"
#include "reports/picture/image.h"
#include "reports/picture/lines.h"
#include "verifier/gate/deviation.h"

namespace limitgauge::reports {

/// Where the part lies on a map seen from +Z: X to the right, Y up.
struct MapFrame {
  double left_mm = 0, top_mm = 0;  ///< X and Y at the upper left corner
  double pixels_per_mm = 1;
  int width = 1, height = 1;

  model::Vec2 pixel(const model::Vec3& p) const {
    return {(p.x - left_mm) * pixels_per_mm, (top_mm - p.y) * pixels_per_mm};
  }
};
/// The frame that shows all of `field` within `largest_width` x `largest_height` pixels.
MapFrame map_frame(const verifier::DeviationField& field, int largest_width, int largest_height);

/// The field from above on a transparent ground: each pixel has the colour of the deviation of the
/// uppermost surface there, unreachable surface is hatched grey, patch borders are fine lines.
Image draw_map(const verifier::DeviationField& field, const DeviationScale& scale,
               const MapFrame& frame);

/// The hatching that stands for unreachable surface at one pixel of a picture that is twice as fine
/// as what is shown.
Rgba hatch_colour(std::size_t x, std::size_t y);
/// Calls `visit(a, b)` with the indices of neighbouring samples all along the borders of patches;
/// of a mesh, of facets.
void visit_borders(const verifier::DeviationField& field,
                   const std::function<void(std::size_t, std::size_t)>& visit);
/// A square of the hatching that stands for unreachable surface.
void draw_hatch(Image& image, int left, int top, int size);

/// deviation.png: the map with its colour bar in numbers, a scale, and the worst gouge and the
/// worst uncut marked, on white.
Image draw_deviation_picture(const verifier::StageDeviation& deviation,
                             const verifier::GateLimits& limits);

}  // namespace limitgauge::reports
