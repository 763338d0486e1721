#pragma once

#include <vector>

#include "engine/strategy/linking/cut_pass.h"
#include "engine/strategy/locations/cutter_locations.h"
#include "engine/strategy/stage_path.h"
#include "model/base/run_control.h"

namespace limitgauge::engine::strategy {

/// Joins passes into a stage's toolpath. Neighbours are linked by the cheapest of: straight on at
/// the link feed where the cutter location surface is clear of it, over what lies between just
/// above it, or a retract to the clear height and a plunge. Groups are cut in their order; within
/// a group the passes may be cut in any order, the nearest next. Every entry, link and lead is
/// proven clear by `locations`.
model::Toolpath link_passes(const std::vector<std::vector<CutPass>>& groups,
                            const CutterLocations& locations, const StageRequest& request,
                            const model::RunControl& control);

/// Height of rapids: above the stock and above every tip position over the part.
double clear_height_mm(const CutterLocations& locations, const StageRequest& request);

}  // namespace limitgauge::engine::strategy
