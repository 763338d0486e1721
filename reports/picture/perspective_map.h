#pragma once

#include "reports/picture/deviation_scale.h"
#include "reports/picture/image.h"
#include "reports/picture/perspective_view.h"

namespace limitgauge::reports {

/// Whether nothing of `depth` is nearer than `p`.
bool is_in_sight(const ScreenPoint& p, const DepthBuffer& depth);

/// A perspective error map on a transparent ground, and what is nearest at each of its pixels.
struct PerspectiveMap {
  Image image;
  DepthBuffer depth;  ///< of the finer picture that `image` is the mean of
  int finer = 1;      ///< how much finer
};
/// Colours by `scale`, lit; unreachable surface hatched, patch borders as fine lines.
PerspectiveMap draw_perspective_map(const verifier::DeviationField& field,
                                    const DeviationScale& scale, const PerspectiveView& view);
/// Only what is nearest: quick, to see what would be in sight.
DepthBuffer perspective_depth(const verifier::DeviationField& field, const PerspectiveView& view);

}  // namespace limitgauge::reports
