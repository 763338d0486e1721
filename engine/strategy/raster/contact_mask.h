#pragma once

#include "engine/strategy/locations/limit_locations.h"
#include "engine/strategy/raster/slope_mask.h"
#include "engine/surface/patch_model.h"

namespace limitgauge::engine::strategy {

/// Where tips stand that touch the limit surface with one of its own normals: p + r n and the flat
/// part's radius outwards, seen from above, for all of the surface that does not face down. The
/// rest of the cutter location surface rolls over open boundaries and creases, which a pass beside
/// them has touched already.
struct ContactReach {
  CellMask cells;
  CellMask steep;        ///< of contacts at least as steep as asked
  double lowest_mm = 0;  ///< tip height of the lowest such contact
};
ContactReach contact_reach(const surface::PatchModel& model, const LimitLocations& limit,
                           const StageRequest& request, const Raster& nodes);

}  // namespace limitgauge::engine::strategy
