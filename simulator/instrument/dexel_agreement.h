#pragma once

#include <cstddef>
#include <optional>

#include "model/base/run_control.h"
#include "model/geometry/pose.h"
#include "simulator/instrument/dexel_stock.h"
#include "simulator/stock/stock_model.h"
#include "simulator/tolerance.h"

namespace limitgauge::simulator {

/// How well the two stock models agree about the same stock. They have no code in common that says
/// what a cutter takes away: where they differ, one of them is wrong.
struct StockAgreement {
  std::size_t lines = 0;  ///< lines of the dexels that were looked at
  std::size_t ends = 0;   ///< ends of their intervals
  /// Largest |φ| of the exact material at an end, where it should be 0.
  double worst_end_mm = 0;
  /// Largest |φ| of the wrong sign in the middle of an interval or of a gap.
  double worst_side_mm = 0;
  model::Vec3 worst_at;  ///< of the larger of the two, in the dexels' frame
  double dexel_volume_mm3 = 0, dexel_error_mm3 = 0;
  double level_set_volume_mm3 = 0, level_set_error_mm3 = 0;

  double volume_difference_mm3() const { return level_set_volume_mm3 - dexel_volume_mm3; }
  /// True where the exact models agree within kAgreement_mm and the volumes within their errors.
  bool agree() const;
};

/// Compares on at most `lines` lines, spread evenly over all; volumes as a whole. The same for any
/// number of threads. `level_set_volume_mm3` is the level set's volume, where it is known already:
/// on coarse grids adding it up takes as long as all the rest. `pose` is how the dexels' frame lies
/// in the level set's: another than the identity at a change of setup, where the level set that is
/// cut again in the next setup's frame is held against the dexels of the setup before.
StockAgreement compare_stocks(const DexelStock& dexels, const StockModel& level_set,
                              std::size_t lines, const model::RunControl& control,
                              std::optional<double> level_set_volume_mm3 = {},
                              const model::Pose& pose = {});

}  // namespace limitgauge::simulator
