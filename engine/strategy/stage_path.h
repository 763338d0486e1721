#pragma once

#include <cstddef>

#include "engine/model/cutter.h"
#include "engine/model/run_control.h"
#include "engine/model/stock.h"
#include "engine/model/toolpath.h"
#include "engine/surface/finish_model.h"

namespace limitgauge::engine::strategy {

enum class Strategy { contour, zigzag };

/// One stage as asked for; lengths mm, feeds mm/min.
struct StageRequest {
  Strategy strategy = Strategy::zigzag;
  model::Cutter cutter;
  double step_mm = 0;       ///< level distance of a contour, plane distance of a zigzag
  double allowance_mm = 0;  ///< material left along the normal of the limit surface
  double tolerance_mm = 0;  ///< the path may leave the exact cutter location surface by this much
  double feed_mm_min = 0;
  double plunge_feed_mm_min = 0;
  double clearance_mm = 0;  ///< height of rapids above the stock
  double floor_z_mm = 0;    ///< lowest tip height that the stage may use
  model::Stock stock;       ///< raw stock of the job
};

/// A stage's toolpath and the figures of the paper's Tables 2 and 3.
struct StagePath {
  model::Toolpath path;
  int planes = 0;                                            ///< section planes or levels
  int sampling_interval_min = 1, sampling_interval_max = 1;  ///< equation 10
  double seconds = 0;
  std::size_t memory_bytes = 0;  ///< of the toolpath
};

/// Plans one stage. The path starts and ends above the stock; no rapid goes below the stock's top
/// but for retracts straight up and plunges down to a clearance above material already cut.
/// Throws std::invalid_argument for a request that no path can serve (names the figure).
StagePath plan_stage(const surface::FinishModel& model, const StageRequest& request,
                     const model::RunControl& control);

}  // namespace limitgauge::engine::strategy
