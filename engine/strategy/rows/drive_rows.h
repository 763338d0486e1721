#pragma once

#include <cmath>
#include <vector>

#include "model/base/angle.h"
#include "model/geometry/vec3.h"

namespace limitgauge::engine::strategy {

/// The frame in which rows run along x and drive planes are perpendicular to y: the part's frame
/// turned about Z. Quarter turns are exact.
class DriveFrame {
 public:
  explicit DriveFrame(double angle_deg) {
    const double turn = std::fmod(angle_deg, 360.0), quarters = turn / 90;
    const bool exact = quarters == std::round(quarters);
    const double angle = model::radians(turn);
    cos_ = exact ? std::round(std::cos(angle)) : std::cos(angle);
    sin_ = exact ? std::round(std::sin(angle)) : std::sin(angle);
  }
  model::Vec3 to_drive(const model::Vec3& p) const {
    return {p.x * cos_ + p.y * sin_, p.y * cos_ - p.x * sin_, p.z};
  }
  model::Vec3 to_part(const model::Vec3& p) const {
    return {p.x * cos_ - p.y * sin_, p.x * sin_ + p.y * cos_, p.z};
  }

 private:
  double cos_ = 1, sin_ = 0;
};

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

/// Places of planes `step_mm` apart from `low_mm` to `high_mm`, where the mesh and the cutter's
/// reach end, as the paper counts planes; what is left of the width is shared by both sides.
std::vector<double> even_places(double low_mm, double high_mm, double step_mm);

}  // namespace limitgauge::engine::strategy
