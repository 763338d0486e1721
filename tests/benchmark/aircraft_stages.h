#pragma once

#include "simulator/stock/stock_model.h"

namespace limitgauge::benchmarks {

/// What fixtures/jobs/aircraft.toml has the engine plan over a block of 90 × 80 × 30 mm.
struct AircraftStages {
  simulator::Pass rough;        ///< flat D8, contours 0.2 mm apart
  simulator::Pass semi_finish;  ///< ball R3, rows 0.25 mm apart, 0.2 mm left
  simulator::Pass finish;       ///< ball R3, rows 0.1 mm apart
};
/// Planned at the first call.
const AircraftStages& aircraft_stages();

}  // namespace limitgauge::benchmarks
