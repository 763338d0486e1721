#pragma once

#include "engine/model/run_control.h"
#include "engine/strategy/stage_path.h"

namespace limitgauge::engine::strategy {

/// A zigzag of any cutter over the cutter location surface of the limit mesh (make_sampled_rows).
StagePath plan_sampled_zigzag(const surface::FinishModel& model, const StageRequest& request,
                              const model::RunControl& control);

}  // namespace limitgauge::engine::strategy
