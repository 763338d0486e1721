#pragma once

#include <cstddef>
#include <vector>

#include "engine/strategy/linking/cut_options.h"
#include "engine/surface/finish_model.h"
#include "model/base/run_control.h"
#include "model/part/cutter.h"
#include "model/part/stock.h"
#include "model/part/toolpath.h"

namespace limitgauge::engine::strategy {

/// One stage as asked for; lengths mm.
struct StageRequest {
  CutOptions cut;
  model::Cutter cutter;
  double allowance_mm = 0;     ///< material left along the normal of the limit surface
  double clearance_mm = 0;     ///< height of rapids above the stock
  double floor_z_mm = 0;       ///< lowest tip height that the stage may use
  double rapid_mm_min = 5000;  ///< what a retract is weighed with
  model::Stock stock;          ///< raw stock of the job
  /// rest: boxes that hold all the material to be cut again; none: nothing is left to cut.
  std::vector<model::Box3> regions;
};

/// A stage's toolpath and the figures of the paper's Tables 2 and 3.
struct StagePath {
  model::Toolpath path;
  int planes = 0;                                            ///< section planes or levels
  int sampling_interval_min = 1, sampling_interval_max = 1;  ///< equation 10
  std::vector<int> sampling_intervals;                       ///< the same, one a patch
  double seconds = 0;
  std::size_t memory_bytes = 0;  ///< of the toolpath
};

/// The intervals of all patches and their extremes.
void set_intervals(StagePath& stage, std::vector<int> intervals);

}  // namespace limitgauge::engine::strategy
