#pragma once

#include <optional>
#include <vector>

#include "engine/model/fixture.h"
#include "simulator/finding.h"
#include "simulator/stock_model.h"

namespace limitgauge::simulator {

/// What a process is checked against.
struct ProcessLimits {
  double tolerance_mm = 0;  ///< contacts shallower than this are none; > 0
  double near_miss_mm = 0;  ///< rapids' cutters, and shanks and holders on any move, within this
                            ///< of stock or fixture are near misses; 0: not looked for
  std::optional<model::Box3> travel_mm;  ///< of the tip, infinite where an axis has no limit
  std::vector<model::Fixture> fixtures;
};

/// Checks `pass` against the stock as it stands at each move: `before` is the stock at the start of
/// the stage. Findings are in the order of moves, then of kinds. The same for any number of
/// threads. Throws std::invalid_argument for limits that cannot be, Interrupted.
std::vector<Finding> check_process(const StockModel& before, const Pass& pass,
                                   const ProcessLimits& limits, const model::RunControl& control);

}  // namespace limitgauge::simulator
