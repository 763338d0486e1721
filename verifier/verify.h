#pragma once

#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "engine/model/cutter.h"
#include "engine/model/run_control.h"
#include "engine/model/stock.h"
#include "engine/model/toolpath.h"
#include "verifier/deviation.h"
#include "verifier/reference_surface.h"

namespace limitgauge::verifier {

/// One pass over the part, in the order of the job. Passes before the stage under test count too:
/// the removed space is everything cut so far and everything outside the raw stock.
struct Pass {
  model::Cutter cutter;
  std::shared_ptr<const model::Toolpath> path;
};

/// A point of the simulated stock's surface, as the voxel instrument reads it.
struct StockReading {
  model::Vec3 position;
  double error_mm = 0;  ///< bound on its distance from the true surface of the cut stock
};

/// How far from S at least a point of the stock is seen to be a leftover or the bottom of a hole.
inline constexpr double kStockSight_mm = 3;

/// What a stage is measured for.
struct StageCheck {
  double allowance_mm = 0;
  GateLimits limits;
  double resolution_mm = 0;        ///< widest certified interval asked for; > 0
  double field_spacing_mm = 0.25;  ///< largest distance between samples of the deviation field
  /// Stock readings are complete within this distance of S sideways and below, and all above.
  double readings_within_mm = 0;
  double voxel_mm = 0;  ///< spacing of the stock readings; 0 when there are none
  std::size_t largest_cell_count = 5'000'000;  ///< where branch and bound gives up
};

/// Resolution "auto": a tenth of the tightest gate limit, 1 µm where nothing is limited.
double automatic_resolution_mm(const GateLimits& limits);

/// Measures the stage whose pass is the last of `passes`. `readings` are points of the simulated
/// stock; the two instruments are compared, and a disagreement beyond their bounds throws
/// InstrumentDisagreement. The result is the same for any number of threads.
StageDeviation measure_stage(const ReferenceSurface& surface, const model::Stock& raw_stock,
                             std::span<const Pass> passes, std::span<const StockReading> readings,
                             const StageCheck& check, const model::RunControl& control);

/// The two instruments contradict each other: an internal error, exit code 4.
class InstrumentDisagreement : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// How often a kind of fault was found in the process, "rapid through standing material" say: what
/// the surface does not show.
struct ProcessFault {
  std::string what;
  std::size_t count = 0;
};

/// The gate's decision rule: pass when every `high` is within its limit, fail when some `low` is
/// beyond it, indeterminate between. Two things that δ, measured to the nearest removed space or
/// material, cannot see are taken from the voxel instrument: thin walls and holes deeper than wide.
/// Each kind of process fault found at least once fails the stage.
GateDecision decide(const StageDeviation& deviation, const GateLimits& limits,
                    std::span<const ProcessFault> faults = {});

}  // namespace limitgauge::verifier
