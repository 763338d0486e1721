#pragma once

#include "engine/strategy/stage_path.h"
#include "engine/surface/finish_model.h"
#include "model/base/run_control.h"

namespace limitgauge::engine::strategy {

/// Iso-planar rows over the whole part, zigzag or one-way, at any angle. Tolerances are
/// those of the rows; links keep clear of the part. With `cut.lean` the rows of a ball that is to
/// lean, as it stands upright, shank and holder not looked at (LeaningRows); plan_stage leans it.
/// Such rows go over a rim no farther than flutes that lean any way by as much still clear it.
StagePath plan_zigzag(const surface::FinishModel& model, const StageRequest& request,
                      const model::RunControl& control);

}  // namespace limitgauge::engine::strategy
