#pragma once

#include "engine/strategy/rows/zigzag.h"
#include "engine/strategy/stage_path.h"
#include "engine/surface/finish_model.h"
#include "model/base/run_control.h"

/// The four strategies and the choice among them.
namespace limitgauge::engine::strategy {

/// Plans one stage. The path starts and ends above the stock; no rapid goes below the stock's top
/// but for retracts straight up and plunges down to a clearance above material already cut.
/// Throws std::invalid_argument for a request that no path can serve (names the figure).
StagePath plan_stage(const surface::FinishModel& model, const StageRequest& request,
                     const model::RunControl& control);

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

/// First the steep, from the top down: so no row has to plunge along a wall that still carries
/// material; then the shallow, whose rows wipe out the marks of the contours' entries on it; last
/// the boundary pass where one is asked for.
///
/// Throws std::invalid_argument for an angle that is not between 0 and 90 degrees, for a negative
/// overlap and for a scallop height that the cutter cannot keep.
StagePath plan_steep_shallow(const surface::FinishModel& model, const StageRequest& request,
                             const model::RunControl& control);

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
