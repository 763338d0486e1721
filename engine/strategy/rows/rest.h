#pragma once

#include "engine/strategy/linking/stage_path.h"
#include "model/base/run_control.h"

namespace limitgauge::engine::strategy {

/// Machines again just what is left (after Zhang): the passes of a steep-and-shallow stage, clipped
/// to where the grown cutter comes within the overlap of one of the request's regions, which hold
/// the places of the surface that are to be cut. No regions: an empty path, since nothing is left.
///
/// Throws std::invalid_argument as plan_steep_shallow does.
StagePath plan_rest(const surface::FinishModel& model, const StageRequest& request,
                    const model::RunControl& control);

/// Whether the rounding or the flat of the cutter, its tip at `tip` and grown by the allowance,
/// comes within `overlap_mm` of one of the regions.
bool comes_near_regions(const StageRequest& request, double overlap_mm, const model::Vec3& tip);

}  // namespace limitgauge::engine::strategy
