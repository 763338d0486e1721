#pragma once

#include "engine/strategy/linking/stage_path.h"
#include "model/base/run_control.h"

namespace limitgauge::engine::strategy {

/// Iso-planar rows over the whole part, zigzag or one-way, at any angle. Tolerances are
/// those of the rows; links keep clear of the part.
StagePath plan_zigzag(const surface::FinishModel& model, const StageRequest& request,
                      const model::RunControl& control);

}  // namespace limitgauge::engine::strategy
