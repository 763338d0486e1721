#pragma once

#include <vector>

#include "engine/model/vec3.h"
#include "engine/surface/grid_section.h"

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
HeightMap make_height_map(const Raster& raster, const std::vector<surface::Grid>& grids);

}  // namespace limitgauge::engine::strategy
