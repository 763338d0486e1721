#pragma once

#include <cstddef>
#include <vector>

#include "engine/surface/offset_model.h"
#include "engine/surface/section/section_chain.h"

namespace limitgauge::engine::surface {

/// The lines over which a cutter rolls without a normal of the surface to follow: open boundaries,
/// borders of holes and infinitely sharp creases, as polylines of limit points; and the points
/// where they turn sharply or end, with conical points of the surface.
struct Rim {
  std::vector<std::vector<Vec3>> lines;
  std::vector<Vec3> points;
};
/// Of the limit mesh as `sampler` samples it.
Rim find_rim(const OffsetSampler& sampler);

/// The upper half of a tube of `radius_mm` around `line`, and of a ball around `point`: where the
/// centre of a ball stands that touches them. Faceted from outside: nowhere nearer than the radius
/// to a chord of the line, and farther by at most `error_mm` plus what the line's turns ask for.
Grid rolling_tube(const std::vector<Vec3>& line, double radius_mm, double error_mm);
Grid rolling_ball(const Vec3& point, double radius_mm, double error_mm);
/// How many points they have.
std::size_t rolling_tube_points(std::size_t line_points, double radius_mm, double error_mm);
std::size_t rolling_ball_points(double radius_mm, double error_mm);

}  // namespace limitgauge::engine::surface
