#include "verifier/union_depth.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace limitgauge::verifier {
namespace {

using model::Vec3;

/// A point counts as left standing from so far outside all bodies: no film between two of them.
constexpr double kOutside_mm = 1e-7;

Bezier moved(Bezier cell, const Vec3& by) {
  for (int k = 0; k < 16; ++k) cell.x[k] += by.x, cell.y[k] += by.y, cell.z[k] += by.z;
  return cell;
}

}  // namespace

/// Out of the deepest body, down through S, and down.
std::array<Vec3, 3> UnionDepth::likely_directions(const Bezier& cell,
                                                  const CellBounds& bounds) const {
  const InnerChords chords = inner_chords(cell);
  const Vec3 down{0, 0, -1};
  const auto unit = [&](const Vec3& v) {
    const double l = length(v);
    return l > 0 ? v / l : down;
  };
  return {unit(bounds.nearest.distance.gradient), -unit(cross(chords.u, chords.v)), down};
}

bool UnionDepth::surely_within(const Bezier& cell, const CellBounds& bounds, double depth_mm) {
  const auto likely = likely_directions(cell, bounds);
  return std::any_of(likely.begin(), likely.end(),
                     [&](const Vec3& d) { return surely_within(cell, d, depth_mm); });
}

bool UnionDepth::surely_within(const Bezier& cell, const Vec3& direction, double depth_mm) {
  return bounder_.surely_outside(moved(cell, direction * depth_mm), kOutside_mm);
}

double UnionDepth::way_out(const Vec3& p, const Vec3& direction, double shorter_than) const {
  constexpr int kMostSteps = 100;
  std::optional<BodyRef> hint;
  double t = 0;
  for (int step = 0; step < kMostSteps && t < shorter_than; ++step) {
    const Nearest at = space_.nearest(p + direction * t, hint);
    if (at.distance.value >= kOutside_mm) return t;
    hint = at.body;
    // As far as the last step went, δ has risen at the most.
    t += 2 * kOutside_mm - at.distance.value;
  }
  return shorter_than;
}

UnionDepth::Exit UnionDepth::exit(const Bezier& cell, const CellBounds& bounds, double enough_mm) {
  constexpr int kAround = 8;
  constexpr double kWidest = 0.4, kNarrowest = 0.02;
  Exit best{{0, 0, -1}, longest_mm_};
  const auto probe = [&](const Vec3& direction) {
    if (best.length_mm <= enough_mm) return;
    const double t = way_out(bounds.middle, direction, best.length_mm);
    if (t < best.length_mm) best = {direction, t};
  };
  const auto probe_cone = [&](const Vec3& axis, double opening) {
    const Vec3 side =
        normalized(cross(axis, std::abs(axis.z) < 0.7 ? Vec3{0, 0, 1} : Vec3{1, 0, 0}));
    const Vec3 other = cross(axis, side);
    for (int k = 0; k < kAround; ++k) {
      const double angle = 2 * std::numbers::pi * k / kAround;
      const Vec3 aside = side * std::cos(angle) + other * std::sin(angle);
      probe(axis * std::cos(opening) + aside * std::sin(opening));
    }
  };
  for (const Vec3& d : likely_directions(cell, bounds)) probe(d);
  probe_cone({0, 0, -1}, std::numbers::pi / 2);
  probe_cone({0, 0, -1}, std::numbers::pi / 4);
  for (double opening = kWidest; opening > kNarrowest; opening /= 2)
    probe_cone(best.direction, opening);
  return best;
}

}  // namespace limitgauge::verifier
