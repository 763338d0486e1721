#pragma once

#include <cmath>

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

}  // namespace limitgauge::engine::strategy
