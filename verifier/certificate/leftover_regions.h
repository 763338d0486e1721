#pragma once

#include <span>
#include <vector>

#include "verifier/gate/verify.h"

namespace limitgauge::verifier {

/// Where a cutter that comes after `passes` could still take something away.
struct LeftoverRequest {
  model::Cutter cutter;     ///< that comes next: what it cannot touch is left out
  double allowance_mm = 0;  ///< that it must leave
  double threshold_mm = 0;  ///< > 0: what stands no higher above the allowance is left out
  double tile_mm = 1;       ///< regions are gathered in tiles of this size
};

struct LeftoverRegions {
  std::vector<model::Box3> boxes;  ///< on the limit surface, in a fixed order
  double area_mm2 = 0;             ///< of the surface that they were gathered from
  /// Every reachable place with more than 1.25 thresholds over the allowance surface lies in a box,
  /// or within 0.01 mm of one that was not proven to be in reach.
  bool complete = true;
};

/// Measures what `passes` have left of the raw stock (find_exceedance), and gathers the places into
/// boxes. The same for any number of threads. Throws std::invalid_argument for a threshold or tile
/// that is not positive.
LeftoverRegions find_leftover_regions(const ReferenceSurface& surface,
                                      const model::Stock& raw_stock, std::span<const Pass> passes,
                                      const LeftoverRequest& request,
                                      const model::RunControl& control);

}  // namespace limitgauge::verifier
