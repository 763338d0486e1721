#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "engine/strategy/rows/row_spacing.h"
#include "model/geometry/vec3.h"

namespace limitgauge::engine::strategy {
namespace {

using model::Vec3;
using Run = std::vector<PlanePoint>;

/// Places looked at, as a share of the rows' distance: the cusp's height varies with the surface,
/// over lengths far greater than the distance of rows.
constexpr double kSpacing = 0.25;

bool before(const PlanePoint& p, double s) {
  return p.s < s;
}

/// Height of a row at `s`, the higher one at a step.
std::optional<double> height_at(const Envelope& row, double s) {
  for (const Run& run : row.runs) {
    if (s < run.front().s || s > run.back().s) continue;
    const auto b = std::lower_bound(run.begin(), run.end(), s, before);
    if (b == run.begin() || b->s == s) return b->z;
    const auto a = b - 1;
    return a->z + (b->z - a->z) * ((s - a->s) / (b->s - a->s));
  }
  return std::nullopt;
}

double distance_to_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 d = b - a;
  const double l2 = length_squared(d);
  const double t = l2 > 0 ? std::clamp(dot(p - a, d) / l2, 0.0, 1.0) : 0.0;
  return distance(p, a + d * t);
}

/// Least distance from `p` to the row at places within `window_mm` of `s`: an upper bound of the
/// distance to the whole row.
double distance_to_row(const CentreRow& row, const Vec3& p, double s, double window_mm) {
  double least = std::numeric_limits<double>::infinity();
  const auto at = [&](const PlanePoint& q) { return Vec3{q.s, row.across_mm, q.z}; };
  for (const Run& run : row.centre.runs) {
    auto b = std::lower_bound(run.begin(), run.end(), s - window_mm, before);
    if (b == run.begin()) ++b;
    for (; b != run.end(); ++b) {
      least = std::min(least, distance_to_segment(p, at(*(b - 1)), at(*b)));
      if (b->s > s + window_mm) break;
    }
  }
  return least;
}

/// Rise of the centre's surface across the rows at `s` of the middle one.
std::optional<double> rise_across(const CentreRow& left, const CentreRow& middle,
                                  const CentreRow& right, double s, double z) {
  const auto zl = height_at(left.centre, s), zr = height_at(right.centre, s);
  if (zl && zr) return (*zr - *zl) / (right.across_mm - left.across_mm);
  if (zl) return (z - *zl) / (middle.across_mm - left.across_mm);
  if (zr) return (*zr - z) / (right.across_mm - middle.across_mm);
  return std::nullopt;
}

}  // namespace

double cusp_between(const CentreRow& left, const CentreRow& middle, const CentreRow& right,
                    double reach_mm) {
  const double distance_mm = right.across_mm - left.across_mm, spacing = kSpacing * distance_mm;
  double highest = 0;
  for (const Run& run : middle.centre.runs) {
    const double length = run.back().s - run.front().s;
    const int steps = static_cast<int>(length / spacing);
    for (int i = 1; i < steps; ++i) {
      const double s = run.front().s + length * i / steps;
      const auto z = height_at(middle.centre, s);
      const auto z0 = height_at(middle.centre, s - spacing / 2);
      const auto z1 = height_at(middle.centre, s + spacing / 2);
      if (!z || !z0 || !z1) continue;
      const auto rise = rise_across(left, middle, right, s, *z);
      if (!rise) continue;
      const Vec3 normal = normalized(Vec3{-(*z1 - *z0) / spacing, -*rise, 1});
      const Vec3 touched = Vec3{s, middle.across_mm, *z} - normal * reach_mm;
      const double near = std::min(distance_to_row(left, touched, s, 2 * distance_mm),
                                   distance_to_row(right, touched, s, 2 * distance_mm));
      if (std::isfinite(near)) highest = std::max(highest, near - reach_mm);
    }
  }
  return highest;
}

}  // namespace limitgauge::engine::strategy
