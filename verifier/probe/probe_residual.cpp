#include "verifier/probe/probe_residual.h"

#include <algorithm>

#include "verifier/probe/standing_point.h"
#include "verifier/tolerance.h"

namespace limitgauge::verifier {

using model::Vec3;

namespace {

SurfaceGap gap_of(const Nearest& nearest) {
  const double steepness = length(nearest.distance.gradient);
  // No negative zero: its sign would stand in the files.
  SurfaceGap gap{0 - nearest.distance.value, {}, nearest.body};
  if (steepness >= kCancels) gap.normal = Vec3{} - nearest.distance.gradient / steepness;
  return gap;
}

}  // namespace

SurfaceGap surface_gap(const RemovedSpace& removed, const Vec3& p, std::optional<BodyRef> hint) {
  return gap_of(removed.nearest(p, hint));
}

ProbeResidual probe_residual(const RemovedSpace& removed, const Vec3& p) {
  const Nearest nearest = removed.nearest(p);
  const double allowed =
      removed.chord_error_mm() + nearest.distance.slack_mm + kDistanceRounding_mm;
  ProbeResidual out{gap_of(nearest), 0, {}};
  out.low_mm = out.gap.value_mm - allowed;
  if (nearest.distance.value >= allowed) {
    out.high_mm = out.gap.value_mm + allowed;
  } else if (const auto standing = standing_point(removed, p, nearest)) {
    // The search looks for the nearest point; where it ends is proven, that it is the nearest not.
    out.high_mm = std::max(standing->distance_mm, out.low_mm);
  }
  return out;
}

}  // namespace limitgauge::verifier
