#pragma once

#include <vector>

#include "engine/strategy/linking/linking.h"
#include "engine/strategy/locations/limit_locations.h"
#include "engine/surface/patch_model.h"
#include "model/base/run_control.h"

namespace limitgauge::engine::strategy {

/// Where the surface ends, as polylines of the limit mesh as it is sampled, with the surface on the
/// left; closed ones repeat their first point. None of a closed surface.
std::vector<std::vector<Vec3>> boundary_lines(const surface::OffsetSampler& sampler);

/// A pass along the outline of the part. Of an open surface: the cutter's axis follows the boundary
/// curve, the tip as low as the cutter location surface lets it (track_tips): it takes off the rags
/// that rows leave where they end. Of a closed one: the contour at the lowest height the stage may
/// use, around all of the part. Climb: the part on the right; conventional: on the left.
std::vector<CutPass> boundary_passes(const LimitLocations& limit, const StageRequest& request,
                                     const model::RunControl& control);

}  // namespace limitgauge::engine::strategy
