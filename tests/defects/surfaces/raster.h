#pragma once

#include <vector>

#include "tests/defects/surfaces/sampled_surface.h"

namespace limitgauge::tests::defects {

/// Rows over a surface and the tips of each, in the order they are cut. A row that leaves the
/// surface and comes back is several.
struct Rows {
  std::vector<std::vector<model::Vec3>> tips;
  int across = 0;  ///< the axis from row to row: 0 for x
};

struct RasterRequest {
  model::Cutter cutter;
  double allowance_mm = 0;
  double step_mm = 0;
  int across = 0;
};

/// Rows that touch the surface moved out by the allowance and gouge it nowhere by more than a
/// fraction of a micrometre: drop-cutter heights, halved along the row until the chords stay above.
Rows gouge_free_rows(const SampledSurface& surface, const RasterRequest& request);

}  // namespace limitgauge::tests::defects
