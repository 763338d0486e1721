#include "engine/strategy/levels/waterline.h"

#include "engine/strategy/locations/height_curve.h"
#include "model/base/chunks.h"

namespace limitgauge::engine::strategy {
namespace {

/// Curves run this much above the height asked for: a plateau there, flat but for rounding and
/// CutterLocations::kHeightError_mm, is free as a whole instead of torn into islands.
constexpr double kAbovePlateaus_mm = 1e-5;

}  // namespace

std::vector<std::vector<Waterline>> waterlines(const CutterLocations& locations,
                                               const TipRaster& tips,
                                               const std::vector<double>& heights_mm,
                                               double tolerance_mm,
                                               const model::RunControl& control) {
  std::vector<std::vector<Waterline>> made(heights_mm.size());
  model::parallel_chunks(made.size(), 1, control, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      made[i] =
          HeightCurves(locations, tips, heights_mm[i] + kAbovePlateaus_mm, tolerance_mm).passes();
    control.report(static_cast<double>(end) / static_cast<double>(made.size()));
  });
  return made;
}

std::vector<std::vector<Waterline>> waterlines(const CutterLocations& locations,
                                               const std::vector<double>& heights_mm,
                                               const WaterlineRequest& request,
                                               const model::RunControl& control) {
  return waterlines(locations,
                    make_tip_raster(locations, request.window, request.spacing_mm, control),
                    heights_mm, request.tolerance_mm, control);
}

}  // namespace limitgauge::engine::strategy
