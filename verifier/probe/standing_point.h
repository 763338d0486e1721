#pragma once

#include <optional>

#include "verifier/cutter/removed_space.h"

namespace limitgauge::verifier {

/// A point that stands, near to one in the air, and how far away it is at the most.
struct StandingPoint {
  model::Vec3 at;
  double distance_mm = 0;
};

/// A point on or in what stands, as near to `p` as a local search finds one; `first` is
/// `removed.nearest(p)`. What is returned was asked for: δ(at) is at least the chords' error, so
/// that it stands whatever the search took for granted (PROBE.md). Nothing where the search finds
/// none.
std::optional<StandingPoint> standing_point(const RemovedSpace& removed, const model::Vec3& p,
                                            const Nearest& first);

}  // namespace limitgauge::verifier
