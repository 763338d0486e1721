#include "verifier/reach/contact_hull.h"

#include <algorithm>
#include <cmath>

#include "verifier/cutter/swept_body.h"

namespace limitgauge::verifier {
namespace {

using model::Vec3;

/// The flat's direction over a cell: e(s) = e₀ + e₁·(e₁·A·(s − m))/|n₀_xy|, but for `apart`.
struct TurningFlat {
  Vec3 ahead, aside;  ///< e₀, and e₁ a quarter turn on
  double level = 0;   ///< |n₀_xy|
  double apart = 0;
};

/// With chord c ≥ |n − n₀|, y = n·e₁ and φ the angle of n_xy to e₀: |y| ≤ c, |n_xy| ≥ l₀ − c, so
/// sin φ = y/|n_xy| is within c²/(l₀·(l₀ − c)) of y/l₀, and 1 − cos φ ≤ sin²φ ≤ (c/(l₀ − c))².
std::optional<TurningFlat> turning_flat(const OffsetCell& cell) {
  const Vec3& n = cell.normal;
  TurningFlat f;
  f.level = std::hypot(n.x, n.y);
  const double chord = 2 * std::sin(std::min(cell.spread_rad, 1.0) / 2);
  const double least = f.level - chord;
  if (!(least > 0) || cell.spread_rad > 1) return std::nullopt;
  f.ahead = {n.x / f.level, n.y / f.level, 0};
  f.aside = {-f.ahead.y, f.ahead.x, 0};
  const double sine = chord / least;
  f.apart = sine * sine + chord * chord / (f.level * least) + cell.remainder / f.level;
  return f;
}

}  // namespace

std::optional<ContactHull> ContactHull::of(const OffsetCell& cell, const CutterProfile& profile,
                                           double allowance_mm) {
  const double reach = profile.rounding_mm + allowance_mm;
  const Bezier cores = cell.moved(reach);
  const Vec3 down{0, 0, -profile.core_mm};
  ContactHull out;
  out.stray_mm = std::abs(reach) * cell.remainder;
  out.middle = cell.moved_middle(reach) + down;
  for (int k = 0; k < 16; ++k) out.tips[k] = cores.control(k) + down;
  if (profile.flat_mm <= 0) return out;
  const auto flat = turning_flat(cell);
  if (!flat) return std::nullopt;
  out.stray_mm += profile.flat_mm * flat->apart;
  out.middle += flat->ahead * profile.flat_mm;
  for (int k = 0; k < 16; ++k) {
    const double turn = dot(flat->aside, cell.turned_to(k)) / flat->level;
    out.tips[k] += (flat->ahead + flat->aside * turn) * profile.flat_mm;
  }
  return out;
}

bool ContactHull::always_below(const CutterProfile& profile, const Vec3& q, double limit_mm) const {
  return std::all_of(tips.begin(), tips.end(), [&](const Vec3& tip) {
    return standing_distance(profile, tip, q).value < limit_mm - stray_mm;
  });
}

}  // namespace limitgauge::verifier
