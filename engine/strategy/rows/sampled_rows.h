#pragma once

#include <vector>

#include "engine/strategy/locations/limit_locations.h"
#include "engine/strategy/raster/tip_track.h"
#include "engine/strategy/rows/drive_rows.h"
#include "model/base/run_control.h"

namespace limitgauge::engine::strategy {

/// How closely tracks follow the cutter locations of a stage.
///
/// Error budget, in shares of the stage's tolerance: twice a quarter for the limit mesh, a fifth by
/// which the path is raised so that no chord cuts into the surface, a tenth for what a chord passes
/// over, 0.15 for points left out. Nothing of it is below the surface.
TrackRule track_rule(const LimitLocations& limit, const StageRequest& request);

/// Rows of any cutter over the whole part and the cutter's radius around it, from the cutter
/// location surface of the limit mesh: points along each row by halving, see track_tips. Where the
/// surface ends a row ends, one radius of the cutter beyond the part; ends that run along the floor
/// touch nothing and are left out.
///
/// A scallop height asks for rows so close that tips of neighbouring rows are at most as far apart
/// as two passes of the corner radius over a plane may be (2 sqrt(2 r h - h²)); over a convex
/// surface that is less than needed. Rows cannot serve surfaces steeper than 75 degrees across
/// them. Throws std::invalid_argument for a scallop height of a cutter without a corner radius: it
/// leaves steps, not cusps.
DriveRows make_sampled_rows(const LimitLocations& limit, const StageRequest& request,
                            const model::RunControl& control);

}  // namespace limitgauge::engine::strategy
