#include "model/gcode/read/arc.h"

#include <algorithm>
#include <cmath>

#include "model/base/tolerance.h"
#include "model/text/number_text.h"

namespace limitgauge::model::gcode {
namespace {

/// LinuxCNC's 0.00005 inch.
constexpr double kSmallestRadiusMm = 0.00005 * 25.4;
constexpr double kSpiralRelative = 0.001;
constexpr double kLargestSpirals = 100;

}  // namespace

ArcCentre centre_by_offset(Vec2 start, Vec2 end, Vec2 centre, double spiral_mm) {
  const double r1_mm = distance(centre, start), r2_mm = distance(centre, end);
  if (std::min(r1_mm, r2_mm) < kSmallestRadiusMm)
    return {centre, "an arc of zero radius", "a centre away from start and end"};
  const double difference_mm = std::abs(r1_mm - r2_mm);
  const bool too_far = difference_mm > kLargestSpirals * spiral_mm;
  const bool visible =
      difference_mm > spiral_mm && difference_mm / std::max(r1_mm, r2_mm) > kSpiralRelative;
  if (too_far || visible)
    return {centre,
            "the arc's radius is " + six_digits(r1_mm) + " mm at its start and " +
                six_digits(r2_mm) + " mm at its end",
            "a centre equally far from both"};
  return {centre, {}, {}};
}

ArcCentre centre_by_radius(Vec2 start, Vec2 end, double radius_mm, bool counter_clockwise) {
  if (start == end)
    return {start, "an arc by radius that ends where it starts", "a centre by I, J, K"};
  const double radius = std::abs(radius_mm);
  if (radius < kSmallestRadiusMm) return {start, "an arc of zero radius", "a radius above 0"};
  const Vec2 middle = (start + end) / 2;
  const double half_chord = distance(start, end) / 2;
  if (half_chord - radius > kSmallestRadiusMm)
    return {middle,
            "a radius of " + six_digits(radius) + " mm does not span the " +
                six_digits(2 * half_chord) + " mm between start and end",
            "at least " + six_digits(half_chord)};
  if (half_chord / radius > 1 - kHalfCircle) return {middle, {}, {}};
  const double offset = std::sqrt((radius - half_chord) * (radius + half_chord));
  const double side = counter_clockwise == (radius_mm > 0) ? 1 : -1;
  const double along = side * offset / (2 * half_chord);
  return {{middle.x - along * (end.y - start.y), middle.y + along * (end.x - start.x)}, {}, {}};
}

}  // namespace limitgauge::model::gcode
