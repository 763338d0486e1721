#include "engine/strategy/raster/tip_raster.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "model/base/chunks.h"

namespace limitgauge::engine::strategy {

TipRaster make_tip_raster(const CutterLocations& locations, const model::Box3& window,
                          double spacing_mm, const model::RunControl& control) {
  constexpr double kMostNodes = 4e6;
  constexpr std::size_t kRowsAChunk = 4;
  const Vec3 size = window.size();
  TipRaster tips;
  Raster& raster = tips.raster;
  raster.pixel_mm = std::max(spacing_mm, std::sqrt(size.x * size.y / kMostNodes));
  raster.x0 = window.low.x;
  raster.y0 = window.low.y;
  raster.columns = 1 + static_cast<int>(std::ceil(size.x / raster.pixel_mm));
  raster.rows = 1 + static_cast<int>(std::ceil(size.y / raster.pixel_mm));
  tips.z.resize(raster.size());
  const auto rows = static_cast<std::size_t>(raster.rows);
  model::parallel_chunks(rows, kRowsAChunk, control, [&](std::size_t begin, std::size_t end) {
    for (std::size_t j = begin; j < end; ++j)
      for (int i = 0; i < raster.columns; ++i)
        tips.z[j * static_cast<std::size_t>(raster.columns) + i] =
            locations.tip_z(raster.x(i), raster.y(static_cast<double>(j)))
                .value_or(-std::numeric_limits<double>::infinity());
  });
  return tips;
}

}  // namespace limitgauge::engine::strategy
