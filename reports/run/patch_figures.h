#pragma once

#include <vector>

#include "verifier/gate/deviation.h"

namespace limitgauge::reports {

/// What the samples of one patch show. Certified figures are for the whole surface; these are for
/// finding the patch.
struct PatchFigures {
  int patch = 0;
  std::size_t samples = 0;
  double gouge_mm = 0;  ///< deepest sample; 0 where none is cut too deep
  double uncut_mm = 0;  ///< highest sample that the cutter can reach; 0 where nothing stands
  double area_mm2 = 0, unreachable_mm2 = 0;

  double unreachable_share() const { return area_mm2 > 0 ? unreachable_mm2 / area_mm2 : 0; }
};

/// A patch of the field each, the worst first: by how large gouge or uncut is against its limit, or
/// in mm where nothing is limited; equals by patch. Of a mesh a facet each, which is `together`
/// patches, and known by the first of them.
std::vector<PatchFigures> patch_figures(const verifier::DeviationField& field,
                                        const verifier::GateLimits& limits, int together = 1);

}  // namespace limitgauge::reports
