#pragma once

#include <vector>

#include "verifier/cells/parameter_index.h"

namespace limitgauge::verifier {

/// A patch in the parameters of another: turned by quarter turns and moved by whole numbers.
struct PlacedPatch {
  int patch = 0;
  int turns = 0;              ///< counter-clockwise, from its own parameters to the chart's
  double at_u = 0, at_v = 0;  ///< lower corner of its square in the chart

  ParameterRect to_own(const ParameterRect& chart) const;
  ParameterRect to_chart(const ParameterRect& own) const;
};

/// Which patches lie smoothly round a patch. Around patch P its parameters go on over a neighbour
/// where position and both derivatives agree along the whole edge, and over a diagonal neighbour
/// where the two ways round the corner lead to the same patch: there S is once continuously
/// differentiable over the rectangle they form, but for a regular corner's rounding. The agreement
/// is tested on the polynomials themselves, at as many points as determine them.
class PatchCharts {
 public:
  PatchCharts(const std::vector<SurfaceCell>& cells, const ParameterIndex& index);

  /// The patch itself first, then those round it.
  const std::vector<PlacedPatch>& around(int patch) const { return charts_[patch]; }
  /// Whether the square at (i, j), each −1, 0 or 1, is part of the chart.
  bool covers(int patch, int i, int j) const;

 private:
  std::vector<std::vector<PlacedPatch>> charts_;
};

}  // namespace limitgauge::verifier
