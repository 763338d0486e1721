#pragma once

#include "engine/strategy/linking/stage_path.h"
#include "engine/strategy/rows/drive_rows.h"
#include "model/base/run_control.h"

namespace limitgauge::engine::strategy {

/// Rows of a ball cutter: in each drive plane the upper envelope of the sections of the offset
/// surface and of what the ball rolls over at rims.
///
/// Error budget, in shares of the stage's tolerance t: twice a quarter for the offset mesh, a tenth
/// for the facets of rims (BallSections), twice a fifth for leaving out points (least_links). A
/// point of the path is within t / 5 of one of the envelope, whose mesh is within t / 4 of the
/// exact offset surface, and the distance from the part changes by no more than the way moved. The
/// centre keeps farther away by both: the ball never goes below the allowance surface, and what it
/// can reach it leaves by at most t more than its rows' distance does. Where the finish model is no
/// finer than t / 4 it leaves more, by what that lacks.
DriveRows make_ball_rows(const surface::FinishModel& model, const StageRequest& request,
                         const model::RunControl& control);

}  // namespace limitgauge::engine::strategy
