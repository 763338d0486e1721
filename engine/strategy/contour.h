#pragma once

#include "engine/model/run_control.h"
#include "engine/strategy/stage_path.h"

namespace limitgauge::engine::strategy {

/// Contour-map pattern with area clearance: level by level from the stock's top to the floor, the
/// whole stock outside the part is cleared by loops at growing distance from the forbidden region,
/// outermost first.
///
/// Gouge-free by construction: a height map bounds the surface from above, the cutter grown by the
/// allowance is bounded by a stack of discs, and every point of a path keeps a non-negative lower
/// bound of its distance to where the discs would touch. The price is up to two pixels of
/// extra allowance at walls. Nothing stays standing that the cutter can reach: a place at distance
/// d from the region has, on the straight line to it, a loop nearer than one step-over, which is
/// less than the cutter's radius.
StagePath plan_contour(const surface::FinishModel& model, const StageRequest& request,
                       const model::RunControl& control);

}  // namespace limitgauge::engine::strategy
