#pragma once

#include <optional>

#include "engine/strategy/locations/limit_locations.h"
#include "engine/strategy/stage_path.h"
#include "engine/surface/finish_model.h"
#include "model/base/run_control.h"

namespace limitgauge::engine::strategy {

/// How far the surface's normal may lean from +Z where axes lean from it: beyond, at walls and
/// where a ball rolls over a rim, it is taken to lean by that.
inline constexpr double kSteepestNormal_deg = 45;

/// The rows of a zigzag whose ball leans. Its centre goes where it would go upright, but that rows
/// go the less far over rims, the more it leans.
class LeaningRows {
 public:
  /// `request.cut.lean` says what the axis leans from, and its lead. Throws std::invalid_argument
  /// without it, for another strategy or cutter, and for a boundary pass. `model` and `control`
  /// must outlive this.
  LeaningRows(const surface::FinishModel& model, const StageRequest& request,
              const model::RunControl& control);

  /// The path with the tool leant by `tilt_deg` across the rows (lean_path). Nothing is said of
  /// what flutes, shank and holder run into.
  StagePath leaning(double tilt_deg) const;

 private:
  model::Vec3 normal_at(double x, double y) const;
  double centre_height_mm(double x, double y) const;

  const surface::FinishModel& model_;
  const model::RunControl& control_;
  StageRequest request_;
  std::optional<CutterLocations> surface_;  ///< where axes lean from the surface
};

}  // namespace limitgauge::engine::strategy
