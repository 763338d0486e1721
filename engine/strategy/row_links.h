#pragma once

#include "engine/strategy/drive_rows.h"
#include "engine/strategy/stage_path.h"

namespace limitgauge::engine::strategy {

/// Cuts the rows of a ball one after another: to and fro, or all the same way.
///
/// Rows are cut from left to right of their direction, so that what is still to be cut lies on the
/// right of a row cut forwards, which is climb milling; from right to left where the options ask
/// for conventional. To and fro has no side.
///
/// Between neighbouring rows the tool stays down just high enough (stay_down_height), otherwise it
/// retracts. A gap within a row is bridged by a straight move: where a row has nothing, nothing is
/// within the ball's reach of its axis in plan, at any height, since the lowest way over it would
/// be a point of the row.
model::Toolpath link_rows(const DriveRows& rows, const StageRequest& request);

}  // namespace limitgauge::engine::strategy
