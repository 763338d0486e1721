#pragma once
// Toolpaths whose result is known in closed form.

#include <cmath>
#include <memory>

#include "model/part/cutter.h"
#include "model/part/toolpath.h"

namespace limitgauge::tests {

inline model::Cutter ball_cutter(double radius_mm) {
  return {"ball", model::CutterType::ball, 2 * radius_mm, radius_mm, 0, 60, {}, {}};
}
inline model::Cutter flat_cutter(double radius_mm) {
  return {"flat", model::CutterType::flat, 2 * radius_mm, 0, 0, 60, {}, {}};
}

inline void feed_to(model::Toolpath& path, const model::Vec3& to) {
  path.moves.push_back(
      {to, 1000.0F, static_cast<std::uint32_t>(path.moves.size() + 1), model::MoveKind::feed});
}

/// Calls visit(x, y) at the places of rows along Y, `step_mm` apart in X over [−half, half]²,
/// points `along_mm` apart in a row. Rows alternate in direction.
template <class Visit>
void along_rows(double half_mm, double step_mm, double along_mm, Visit&& visit) {
  const int rows = static_cast<int>(std::lround(2 * half_mm / step_mm));
  const int points = static_cast<int>(std::lround(2 * half_mm / along_mm));
  for (int row = 0; row <= rows; ++row)
    for (int k = 0; k <= points; ++k)
      visit(-half_mm + row * step_mm, -half_mm + along_mm * (row % 2 == 0 ? k : points - k));
}

/// A path along such rows; the height of the tip over (x, y) is `tip_z`.
template <class TipZ>
model::Toolpath raster(double half_mm, double step_mm, double along_mm, TipZ&& tip_z) {
  model::Toolpath path;
  along_rows(half_mm, step_mm, along_mm, [&](double x, double y) {
    const model::Vec3 tip{x, y, tip_z(x, y)};
    if (path.moves.empty()) path.start = tip;
    feed_to(path, tip);
  });
  return path;
}

inline std::shared_ptr<const model::Toolpath> shared(model::Toolpath path) {
  return std::make_shared<const model::Toolpath>(std::move(path));
}

}  // namespace limitgauge::tests
