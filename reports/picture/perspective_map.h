#pragma once

#include <span>
#include <vector>

#include "reports/picture/deviation_scale.h"
#include "reports/picture/image.h"
#include "reports/picture/perspective_view.h"

namespace limitgauge::reports {

/// Whether nothing of `depth` is nearer than `p`.
bool is_in_sight(const ScreenPoint& p, const DepthBuffer& depth);

/// A perspective error map on a transparent ground.
struct PerspectiveMap {
  Image image;
  std::vector<bool> in_sight;  ///< of the places that were asked for: none outside the picture
};
/// Colours by `scale`, lit; unreachable surface hatched, patch borders as fine lines. Says which of
/// `places` nothing hides.
PerspectiveMap draw_perspective_map(const verifier::DeviationField& field,
                                    const DeviationScale& scale, const PerspectiveView& view,
                                    std::span<const model::Vec3> places = {});
/// Only what is nearest: quick, to see what would be in sight.
DepthBuffer perspective_depth(const verifier::DeviationField& field, const PerspectiveView& view);

}  // namespace limitgauge::reports
