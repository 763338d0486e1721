#pragma once

#include <optional>

#include "verifier/cutter/removed_space.h"

namespace limitgauge::verifier {

/// How far a point is from the simulated stock's surface: −δ, positive in the air. Zero on the
/// surface and nowhere else; within material the exact distance, in the air the depth into the
/// deepest body that holds the point, which is no more than the distance.
struct SurfaceGap {
  double value_mm = 0;
  model::Vec3 normal;  ///< slope of the value, a unit vector out of the material; zero: has none
  BodyRef body;        ///< that the value is of
};

/// `hint`, any body, saves time where it is near, and changes nothing.
SurfaceGap surface_gap(const RemovedSpace& removed, const model::Vec3& p,
                       std::optional<BodyRef> hint = {});

/// The gap with a certified interval round the true residual: the distance to the simulated stock,
/// positive in the air above it, negative within it (PROBE.md).
struct ProbeResidual {
  SurfaceGap gap;
  double low_mm = 0;
  std::optional<double> high_mm;  ///< none: no point was proven to stand
};

ProbeResidual probe_residual(const RemovedSpace& removed, const model::Vec3& p);

}  // namespace limitgauge::verifier
