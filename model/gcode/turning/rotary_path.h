#pragma once

#include <vector>

#include "model/machine/kinematics.h"
#include "model/part/toolpath.h"

namespace limitgauge::model {

/// A place as a program for a machine with rotary axes names it, with the tool's tip under control.
struct RotaryPlace {
  Vec3 tip_mm;  ///< in the work frame, the workpiece as it lies with all rotary axes at zero
  RotaryAngles angles_deg{};
  MoveKind kind = MoveKind::rapid;
  float feed_mm_min = 0;  ///< of a feed move
};

/// What a path whose tool turns is to be posted for.
struct RotaryRequest {
  const Kinematics& machine;
  Pose work_from_part = {};     ///< from the path's frame to the work frame
  Pose machine_from_part = {};  ///< ... to the machine's, all rotary axes at zero
  /// How far up the axis from the tip the place is that keeps to its way: the ball's centre.
  double centre_mm = 0;
  /// By how much, while a machine's axes turn evenly, that place may be off where the great circle
  /// of the path's axis has it; greater than 0.
  double bend_mm = 0.001;
  int decimals = 4;  ///< of coordinates and angles
};

/// The places of a program: the path's, and more where the axes' even turns would leave it.
struct RotaryPath {
  Vec3 start_mm;  ///< of the tip in the work frame, all rotary axes at zero
  std::vector<RotaryPlace> to;
};

/// Angles for every move of a path that begins and ends with the tool along the machine's Z. While
/// the tool cuts its axes go on from where they are; at a rapid that turns the tool they go to that
/// solution, the nearest first, from which they can go on within their limits to the next such
/// rapid. Angles are rounded, and then the tip, so that `centre_mm` up the tool is where the path
/// has it but for the rounding of coordinates.
///
/// Throws std::invalid_argument, with the place, where no angles within the limits do, or where
/// they would have to jump while the tool cuts; and for a path that does not begin along Z.
RotaryPath rotary_path(const Toolpath& path, const ToolAxes& axes, const RotaryRequest& request);

}  // namespace limitgauge::model
