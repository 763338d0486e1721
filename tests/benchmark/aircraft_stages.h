#pragma once

#include "simulator/pass.h"

namespace limitgauge::benchmarks {

/// What fixtures/jobs/aircraft.toml has the engine plan, over a block of 90 × 80 × 30 mm. Planned
/// anew at each call.
struct AircraftStages {
  simulator::Pass rough;   ///< flat D8, contours 0.2 mm apart
  simulator::Pass finish;  ///< ball R3, rows 0.1 mm apart
};
AircraftStages plan_aircraft_stages();

}  // namespace limitgauge::benchmarks
