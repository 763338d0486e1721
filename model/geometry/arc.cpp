#include "model/geometry/arc.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace limitgauge::model {
namespace {

/// Wider chords would not follow an arc's direction, however wide the tolerance.
constexpr double kWidestChord = std::numbers::pi / 2;
/// Counted in doubles so far beyond what anyone cuts, chords are no whole numbers any more.
constexpr double kMostChords = 1e15;

/// The widest chord, in radians, that keeps the error within the limit.
double widest_chord(const Arc& arc, double limit_mm) {
  if (arc.radius_growth_mm == 0)
    return 4 * std::asin(std::sqrt(std::min(1.0, limit_mm / (2 * arc.radius_mm))));
  const double at_one_radian_mm = arc.error_mm(std::abs(arc.swept));
  return std::sqrt(limit_mm / at_one_radian_mm);
}

}  // namespace

Vec3 Arc::point_at(double fraction) const {
  const double at = angle + fraction * swept;
  const double from_centre_mm = radius_mm + fraction * radius_growth_mm;
  return centre + axis1 * (from_centre_mm * std::cos(at)) +
         axis2 * (from_centre_mm * std::sin(at)) + rise_mm * fraction;
}

double Arc::error_mm(double chords) const {
  if (radius_growth_mm != 0) return even_error_mm(chords);
  const double s = std::sin(std::abs(swept) / chords / 4);
  return 2 * radius_mm * s * s;
}

double Arc::even_error_mm(double chords) const {
  const double h = std::abs(swept) / chords;
  const double widest_mm = radius_mm + std::max(0.0, radius_growth_mm);
  return h * h / 8 * std::hypot(widest_mm, 2 * radius_growth_mm / swept);
}

double Arc::chords_within(double limit_mm) const {
  const double widest = std::min(kWidestChord, widest_chord(*this, limit_mm));
  double chords = std::ceil(std::abs(swept) / widest);
  if (!(chords < kMostChords)) return kMostChords;
  while (error_mm(chords) > limit_mm) ++chords;
  return chords;
}

}  // namespace limitgauge::model
