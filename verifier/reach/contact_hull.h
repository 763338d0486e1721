#pragma once

#include <array>
#include <optional>

#include "verifier/cells/offset_cell.h"
#include "verifier/cutter/cutter_profile.h"

namespace limitgauge::verifier {

/// Where the tip stands while a cutter touches the points s of one cell with its bottom or corner,
/// at a distance a,
///   T(s) = s + (rounding + a)·n(s) + flat·e(s) − core·z,   e = n_xy/|n_xy|,
/// lies within `stray_mm` of the hull of sixteen tips. The normals turn in it as the surface does,
/// so the stray shrinks with the square of the cell's size, and where the cutter is bent as S is,
/// the hull with it (proof: CERTIFICATE.md, section 4).
struct ContactHull {
  std::array<model::Vec3, 16> tips;
  model::Vec3 middle;  ///< the tip that touches the cell's middle
  double stray_mm = 0;

  /// Empty where the flat's direction turns too far to be followed, as where the cell is level.
  static std::optional<ContactHull> of(const OffsetCell& cell, const CutterProfile& profile,
                                       double allowance_mm);
  /// Whether the endless cutter comes nearer than the limit to `q` from every T(s): its distance
  /// is convex in the tip.
  bool always_below(const CutterProfile& profile, const model::Vec3& q, double limit_mm) const;
};

}  // namespace limitgauge::verifier
