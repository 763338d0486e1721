#pragma once

#include <vector>

#include "engine/surface/offset_model.h"
#include "model/geometry/vec3.h"

namespace limitgauge::engine::strategy {

/// A raster over the XY plane: square pixels of `pixel_mm`, pixel (0, 0) centred at (x0, y0).
struct Raster {
  double x0 = 0, y0 = 0, pixel_mm = 0;
  int columns = 0, rows = 0;

  double x(double column) const { return x0 + column * pixel_mm; }
  double y(double row) const { return y0 + row * pixel_mm; }
  std::size_t size() const {
    return static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
  }
};
/// The raster that covers the box's XY extent with whole pixels.
Raster cover(const model::Box3& box, double pixel_mm);

/// For every pixel a height that no point of the surface over that pixel's square exceeds; minus
/// infinity where there is no surface.
struct HeightMap {
  Raster raster;
  std::vector<float> z;
};
/// The surface is the limit mesh as it is sampled.
HeightMap make_height_map(const Raster& raster, const surface::OffsetSampler& sampler);
/// The same with `factor` times larger pixels: the highest of the pixels that each one holds.
HeightMap coarsened(const HeightMap& map, int factor);

/// Columns and rows of a raster, first and last included.
struct Window {
  int first_column = 0, first_row = 0, last_column = -1, last_row = -1;

  bool empty() const { return first_column > last_column || first_row > last_row; }
  int columns() const { return last_column - first_column + 1; }
  int rows() const { return last_row - first_row + 1; }
};
inline Window whole(const Raster& r) {
  return {0, 0, r.columns - 1, r.rows - 1};
}
Window overlap(const Window& a, const Window& b);
inline Window grown(const Window& w, int by) {
  return {w.first_column - by, w.first_row - by, w.last_column + by, w.last_row + by};
}
/// The pixels of `raster` that cover the box's XY extent; none outside the raster.
Window covering(const Raster& raster, const model::Box3& box);
/// The pixels of `window` as a raster of their own.
Raster part_of(const Raster& raster, const Window& window);

}  // namespace limitgauge::engine::strategy
