#include "engine/strategy/levels/level_space.h"

#include <algorithm>
#include <limits>

namespace limitgauge::engine::strategy {
namespace {

/// Bilinear interpolation of a distance adds less than this share of a pixel.
constexpr double kInterpolation = 0.1;

/// Interpolated; beyond the raster its border's values are taken.
double interpolated(const Raster& r, const std::vector<float>& field, const FlatPoint& p) {
  const double u = std::clamp((p.x - r.x0) / r.pixel_mm, 0.0, r.columns - 1.0);
  const double v = std::clamp((p.y - r.y0) / r.pixel_mm, 0.0, r.rows - 1.0);
  const int i = std::min(static_cast<int>(u), r.columns - 2);
  const int j = std::min(static_cast<int>(v), r.rows - 2);
  const float* low = &field[static_cast<std::size_t>(j) * r.columns + i];
  const float* high = low + r.columns;
  const double s = u - i, t = v - j;
  return (low[0] * (1 - s) + low[1] * s) * (1 - t) + (high[0] * (1 - s) + high[1] * s) * t;
}

bool covers(const Raster& r, const FlatPoint& p) {
  const double u = (p.x - r.x0) / r.pixel_mm, v = (p.y - r.y0) / r.pixel_mm;
  return u >= 0 && v >= 0 && u <= r.columns - 1 && v <= r.rows - 1;
}

}  // namespace

double LevelSpace::clear_at(const FlatPoint& p) const {
  if (!anything_forbidden()) return std::numeric_limits<double>::infinity();
  const double far =
      interpolated(raster_, everywhere_.clear_mm, p) - kInterpolation * raster_.pixel_mm;
  if (near_.clear_mm.empty() || !covers(near_.raster, p)) return far;
  return std::max(
      far, interpolated(near_.raster, near_.clear_mm, p) - kInterpolation * near_.raster.pixel_mm);
}

/// From each place as far as it is clear, but by half a fine pixel at least: what lies between is
/// then within a quarter of a place looked at.
bool LevelSpace::clear_between(const FlatPoint& a, const FlatPoint& b) const {
  if (!anything_forbidden()) return true;
  const double length = distance(a, b);
  const double pixel = near_.clear_mm.empty() ? raster_.pixel_mm : near_.raster.pixel_mm;
  for (double way = 0;;) {
    const double t = length > 0 ? way / length : 0;
    const double clear = clear_at(lerp(a, b, t));
    if (clear < pixel / 4) return false;
    if (way >= length) return true;
    way = std::min(length, way + std::max(clear, pixel / 2));
  }
}

}  // namespace limitgauge::engine::strategy
