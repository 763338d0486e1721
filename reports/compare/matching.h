#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "model/geometry/vec3.h"

namespace limitgauge::reports::compare {

/// A finding's place, and how far from it the same finding of another run may lie.
struct Spot {
  model::Vec3 at_mm;
  double reach_mm = 0;
};

struct Match {
  std::size_t base = 0, now = 0;
  double distance_mm = 0;
};

/// Pairs spots of two runs one to one, nearest first, none further apart than the larger reach of
/// the two. Spots at the very same place always find each other. Takes about n log n; among more
/// than a handful of spots closer together than their reach some may stay single.
std::vector<Match> match_spots(std::span<const Spot> base, std::span<const Spot> now);

}  // namespace limitgauge::reports::compare
