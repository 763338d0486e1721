#pragma once

#include "engine/model/run_control.h"
#include "engine/strategy/stage_path.h"

namespace limitgauge::engine::strategy {

/// Zigzag pattern for ball cutters: drive planes perpendicular to X, in each the upper envelope of
/// the sections of the offset surface and of what the ball rolls over at rims.
///
/// Error budget, in shares of the stage's tolerance: half for the offset mesh, a tenth for the
/// facets of rims, a quarter for leaving out points. Where a patch cannot keep its share the whole
/// offset grows by what it lacks.
StagePath plan_zigzag(const surface::FinishModel& model, const StageRequest& request,
                      const model::RunControl& control);

}  // namespace limitgauge::engine::strategy
