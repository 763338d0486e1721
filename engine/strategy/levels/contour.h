#pragma once

#include "engine/strategy/linking/stage_path.h"
#include "model/base/run_control.h"

namespace limitgauge::engine::strategy {

/// Contour-map pattern with area clearance: level by level from the stock's top to the floor, the
/// whole stock outside the part is cleared by loops around the forbidden region, outermost first.
///
/// Gouge-free by construction: a height map bounds the surface from above, the cutter grown by the
/// allowance is bounded by a stack of discs, and every point of a path keeps a non-negative lower
/// bound of its distance to where the discs would touch. The price is up to two pixels of
/// extra allowance at walls. Nothing stays standing that the cutter can reach, but for cusps of
/// rounded cutters that are lower than a level is thick: see level_loops.
///
/// With climb milling loops keep the part on their right, conventional ones on their left;
/// otherwise open loops begin at their nearer end. A loop is reached straight on where the way is
/// clear, from beside the stock, straight down where nothing stands (to a pixel), else along a ramp
/// or a helix at the stage's angle; a place with no room for either is plunged into.
/// Throws std::invalid_argument for a link feed that is not positive and a ramp angle that is not
/// between 0 and 90 degrees.
StagePath plan_contour(const surface::FinishModel& model, const StageRequest& request,
                       const model::RunControl& control);

}  // namespace limitgauge::engine::strategy
