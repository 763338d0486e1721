#include "model/gcode/arc_chords.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "model/base/tolerance.h"

namespace limitgauge::model {
namespace {

/// Wider chords would not follow an arc's direction, however wide the tolerance.
constexpr double kWidestChord = std::numbers::pi / 2;
/// Counted in doubles so far beyond what anyone cuts, chords are no whole numbers any more.
constexpr double kMostChords = 1e15;

/// The widest chord, in radians, that keeps the error within the limit.
double widest_chord(const ArcSweep& sweep, double limit_mm) {
  if (sweep.radius_growth_mm == 0)
    return 4 * std::asin(std::sqrt(std::min(1.0, limit_mm / (2 * sweep.radius_mm))));
  const double at_one_radian_mm = sweep.error_mm(std::abs(sweep.swept));
  return std::sqrt(limit_mm / at_one_radian_mm);
}

}  // namespace

ArcSweep::ArcSweep(const Motion& arc, const Vec3& start)
    : axes(axes_of(arc.plane)), centre1(arc.centre1), centre2(arc.centre2) {
  const auto [first, second, normal] = axes;
  const double x1 = start[first] - arc.centre1, y1 = start[second] - arc.centre2;
  const double x2 = arc.to[first] - arc.centre1, y2 = arc.to[second] - arc.centre2;
  const double direction = arc.turns < 0 ? -1 : 1;
  angle = std::atan2(y1, x1);
  double forward = direction * (std::atan2(y2, x2) - angle);
  while (forward < kFullTurn_rad) forward += 2 * std::numbers::pi;
  forward += 2 * std::numbers::pi * (std::max(1.0, std::abs(arc.turns)) - 1);
  swept = direction * forward;
  radius_mm = std::hypot(x1, y1);
  radius_growth_mm = std::hypot(x2, y2) - radius_mm;
  height_mm = start[normal];
  rise_mm = arc.to[normal] - start[normal];
}

Vec3 ArcSweep::point_at(double fraction) const {
  const double at = angle + fraction * swept;
  const double from_centre_mm = radius_mm + fraction * radius_growth_mm;
  Vec3 point;
  point[axes[0]] = centre1 + from_centre_mm * std::cos(at);
  point[axes[1]] = centre2 + from_centre_mm * std::sin(at);
  point[axes[2]] = height_mm + fraction * rise_mm;
  return point;
}

double ArcSweep::error_mm(double chords) const {
  if (radius_growth_mm != 0) return even_error_mm(chords);
  const double s = std::sin(std::abs(swept) / chords / 4);
  return 2 * radius_mm * s * s;
}

double ArcSweep::even_error_mm(double chords) const {
  const double h = std::abs(swept) / chords;
  const double widest_mm = radius_mm + std::max(0.0, radius_growth_mm);
  return h * h / 8 * std::hypot(widest_mm, 2 * radius_growth_mm / swept);
}

double ArcSweep::chords_within(double limit_mm) const {
  const double widest = std::min(kWidestChord, widest_chord(*this, limit_mm));
  double chords = std::ceil(std::abs(swept) / widest);
  if (!(chords < kMostChords)) return kMostChords;
  while (error_mm(chords) > limit_mm) ++chords;
  return chords;
}

}  // namespace limitgauge::model
