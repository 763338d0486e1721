#pragma once

#include <vector>

#include "model/part/cutter.h"
#include "simulator/process/process_check.h"
#include "simulator/process/turn_search.h"

namespace limitgauge::simulator {

/// A motion during which rotary axes turn, and with them the tool among the stock, or the stock and
/// what is mounted with it.
struct TurningTool {
  std::uint32_t line = 0;
  bool rapid = true;
  TurningPose in_stock;                  ///< in the stock's frame
  std::vector<TurningPose> in_fixtures;  ///< one a fixture, in the frame that its mesh is in
};

/// What a tool touches during a turn: any part of it, flutes included, since what they would cut is
/// not simulated. Of flutes in the stock that is rapid_through_stock or, at a feed rate,
/// cut_while_turning; of what is above them shank_in_stock or holder_in_stock; of any part in a
/// fixture fixture_touched. Contacts down to a tenth of the tolerance are slight_contact, distances
/// below `near_miss_mm` near_miss. One finding a part and thing, the deepest; `move` is 0, points
/// are in the stock's frame. A contact deeper than one and a half tolerances is never missed: where
/// the search cannot exclude one it is a finding of depth 0. The same for any number of threads.
/// Throws std::invalid_argument for limits that cannot be, for a fixture that is no closed solid or
/// has no pose, Interrupted.
std::vector<Finding> check_turn(const StockModel& stock, const model::Cutter& cutter,
                                const TurningTool& motion, const ProcessLimits& limits,
                                const model::RunControl& control);

}  // namespace limitgauge::simulator
