#pragma once

#include <optional>

#include "model/part/toolpath.h"

namespace limitgauge::model {

/// What a machine's drives and its control make of programmed feeds.
struct MachineRates {
  double rapid_mm_min = 0;
  /// Of the tool along its path, in every direction; empty: speeds change at once.
  std::optional<double> acceleration_mm_s2;
  /// How far a corner may be rounded off.
  double junction_deviation_mm = 0.01;
};

/// Square of the speed, in (mm/s)², at which a corner is passed between moves of length `before_mm`
/// and `after_mm` in the directions (unit vectors) `before` and `after`: the greatest at which the
/// acceleration keeps the tool on a circle that touches both moves. The circle passes the corner
/// within the junction deviation d, as Grbl has it (radius d s / (1 - s), s the sine of half the
/// angle between the moves), and it touches neither move beyond its middle: that bounds the speed
/// along the chords of a curve by the curve's own radius. Infinite where the moves are in line, 0
/// where the second goes back on the first.
double corner_speed_squared(const Vec3& before, double before_mm, const Vec3& after,
                            double after_mm, double acceleration_mm_s2, double deviation_mm);

/// Time that `path` takes from rest to rest, in s. Along each move the tool speeds up to the
/// programmed feed (rapids: to the rapid rate) and slows down at the acceleration; it passes
/// corners at most at corner_speed_squared and at the lower of the two feeds, and never faster than
/// it can slow down from in what lies ahead. Never less than lengths().time_s, and never more where
/// the acceleration is greater. Without an acceleration: lengths().time_s. Moves without a rate,
/// and those of no length, take no time. Throws std::invalid_argument unless an acceleration and a
/// junction deviation are greater than 0.
double machining_time_s(const Toolpath& path, const MachineRates& machine);

}  // namespace limitgauge::model
