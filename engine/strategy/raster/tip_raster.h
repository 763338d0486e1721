#pragma once

#include <vector>

#include "engine/strategy/locations/cutter_locations.h"
#include "engine/strategy/raster/height_map.h"
#include "engine/strategy/stage_path.h"
#include "model/base/run_control.h"

namespace limitgauge::engine::strategy {

/// Tip heights at the nodes of a raster; minus infinity where nothing is under the cutter.
struct TipRaster {
  Raster raster;
  std::vector<double> z;
  /// How far, along its normal, the surface that the heights are of may lie from the exact cutter
  /// location surface, mm; none: heights are exact.
  double error_mm = 0;

  double at(int column, int row) const {
    return z[static_cast<std::size_t>(row) * raster.columns + column];
  }
};

/// Nodes over the XY extent of `window`, borders included, at most `spacing_mm` apart, but no more
/// than four million of them.
TipRaster make_tip_raster(const CutterLocations& locations, const model::Box3& window,
                          double spacing_mm, const model::RunControl& control);

/// The same from sections of the offset surface, for a ball whose shank and holder touch nothing:
/// an order of magnitude faster.
TipRaster make_ball_raster(const surface::PatchModel& model, const StageRequest& request,
                           const model::Box3& window, double spacing_mm,
                           const model::RunControl& control);

}  // namespace limitgauge::engine::strategy
