#pragma once

#include <span>
#include <vector>

#include "engine/strategy/locations/envelope.h"
#include "engine/strategy/rows/drive_rows.h"
#include "engine/strategy/stage_path.h"
#include "engine/surface/patch_model.h"
#include "engine/surface/section/grid_section.h"
#include "model/base/run_control.h"

namespace limitgauge::engine::strategy {

/// Share of a stage's tolerance by which leaving out points may move a row.
inline constexpr double kRowReductionShare = 0.2;

/// All that a ball's centre must stay above, ready to be cut by drive planes: the surface moved out
/// by the ball's radius and the allowance, and what the ball rolls over at rims.
///
/// The centre keeps farther away by what the offset mesh may lack (a quarter of the stage's
/// tolerance, or more where the model is no finer) and by what leaving out points of rows may take
/// (`reduction_mm`): nothing of that cuts into the surface. Facets of rims lie outside what they
/// stand for, by a tenth of the tolerance at most.
class BallSections {
 public:
  BallSections(const surface::PatchModel& model, const StageRequest& request,
               const DriveFrame& frame, double reduction_mm, const model::RunControl& control);

  double reach_mm() const { return reach_; }  ///< of the centre from the surface
  /// Extent of the surface across the rows.
  double low_mm() const { return low_; }
  double high_mm() const { return high_; }
  const std::vector<int>& sampling_intervals() const { return intervals_; }

  /// The gouge-free paths of the centre in the planes at `across_mm` (ascending): s is the place
  /// along the row.
  std::vector<Envelope> envelopes(std::span<const double> across_mm,
                                  const model::RunControl& control) const;

 private:
  std::vector<surface::Grid> all_grids(const surface::PatchModel& model,
                                       const StageRequest& request, double reduction_mm);
  void measure(const surface::PatchModel& model, const DriveFrame& frame);

  double reach_, low_ = 0, high_ = 0;
  std::vector<int> intervals_;
  std::vector<surface::GridSection> sections_;
};

}  // namespace limitgauge::engine::strategy
