#pragma once

#include <vector>

#include "engine/strategy/levels/curve_need.h"
#include "engine/strategy/locations/cutter_locations.h"
#include "engine/strategy/raster/tip_raster.h"
#include "model/base/run_control.h"

namespace limitgauge::engine::strategy {

/// Curves of constant tip height on the cutter location surface: where a contour pass runs.
struct Waterline {
  std::vector<model::Vec3> tips;  ///< all at one height; the first is not repeated
  bool closed = true;
};

struct WaterlineRequest {
  model::Box3 window;       ///< XY extent in which curves are looked for
  double spacing_mm = 0;    ///< of the raster that finds them: narrower islands may be missed
  double tolerance_mm = 0;  ///< chords leave the true curve by at most this, outwards only
};

/// The curves at each of `heights_mm`, the forbidden side (higher) on the right of the way: cut in
/// this order they are climb milling. Chords are proven clear of the surface; where that cannot be
/// done the curve is left open. Tips run 1e-5 mm above the heights asked for, so that a plateau at
/// one of them is free as a whole.
std::vector<std::vector<Waterline>> waterlines(const CutterLocations& locations,
                                               const std::vector<double>& heights_mm,
                                               const WaterlineRequest& request,
                                               const model::RunControl& control);
/// The same from tip heights that are there already, over the cells of their raster in `need`:
/// what of a curve lies elsewhere may be left out, and the curve is open there.
std::vector<std::vector<Waterline>> waterlines(const CutterLocations& locations,
                                               const TipRaster& tips, const CurveNeed& need,
                                               const std::vector<double>& heights_mm,
                                               double tolerance_mm,
                                               const model::RunControl& control);

}  // namespace limitgauge::engine::strategy
