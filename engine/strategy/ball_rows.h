#pragma once

#include "engine/model/run_control.h"
#include "engine/strategy/drive_rows.h"
#include "engine/strategy/stage_path.h"

namespace limitgauge::engine::strategy {

/// Rows of a ball cutter: in each drive plane the upper envelope of the sections of the offset
/// surface and of what the ball rolls over at rims.
///
/// Error budget, in shares of the stage's tolerance t: half for the offset mesh and a tenth for the
/// facets of rims (BallSections), a quarter for leaving out points (least_links), the rest for
/// rounding. A point of the path is within t / 4 of one of the envelope, which is within t / 2 of
/// the exact offset surface, and the distance from the part changes by no more than the way moved:
/// the ball goes below the allowance surface by at most t, and what it can reach it leaves by at
/// most t more than its rows' distance does.
DriveRows make_ball_rows(const surface::FinishModel& model, const StageRequest& request,
                         const model::RunControl& control);

}  // namespace limitgauge::engine::strategy
