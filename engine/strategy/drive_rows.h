#pragma once

#include <vector>

#include "engine/model/run_control.h"
#include "engine/strategy/stage_path.h"

namespace limitgauge::engine::strategy {

/// The gouge-free path of the tip in one drive plane: vertical, along `CutOptions::angle_deg`.
/// Runs go along the rows' direction; between runs there is nothing under the cutter. Points are
/// reduced: chords stay within the stage's tolerance of the exact cutter location surface, never
/// below it by more than that.
struct DriveRow {
  double across_mm = 0;  ///< distance of the plane from the origin, to the left of the direction
  std::vector<std::vector<model::Vec3>> runs;
};

struct DriveRows {
  std::vector<DriveRow> rows;           ///< by ascending across_mm
  std::vector<int> sampling_intervals;  ///< equation 10, one a patch
};

/// Rows over the whole part and the cutter's radius around it, `step_mm` apart or closer where a
/// scallop height asks for it. Balls take the paper's way (sections of the offset surface and
/// their upper envelope), other cutters the cutter location surface of the limit mesh.
DriveRows make_rows(const surface::FinishModel& model, const StageRequest& request,
                    const model::RunControl& control);

}  // namespace limitgauge::engine::strategy
