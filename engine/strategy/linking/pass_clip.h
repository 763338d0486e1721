#pragma once

#include <vector>

#include "engine/strategy/raster/slope_mask.h"

namespace limitgauge::engine::strategy {

/// A part of a polyline of tips that lies where it is wanted.
struct ClippedPass {
  std::vector<Vec3> tips;
  bool closed = false;  ///< only of a closed polyline that is wanted as a whole
};

/// Which gaps along a polyline are cut all the same, since going around takes longer: those of at
/// most `longest_mm`, no more than `repeated_mm` of it over cells of `touched`, where other passes
/// cut. The rest rolls over edges of the part and does no harm.
struct BridgeRule {
  const CellMask& touched;
  double repeated_mm = 0, longest_mm = 0;
};

/// The parts of `tips` over set cells of `wanted`; borders are met to half a cell. The first point
/// of a closed polyline is not repeated.
std::vector<ClippedPass> clip_to(const std::vector<Vec3>& tips, bool closed, const CellMask& wanted,
                                 const BridgeRule& rule);

/// How rows go on into what contours cut.
struct SteepClip {
  double angle_rad = 0;   ///< slope along the row from which it is steep
  double overlap_mm = 0;  ///< how far a row follows a steep stretch from either end
};
/// The same for a row, without the inner parts of its steep stretches: over a wall, which has no
/// extent seen from above, rows stop `overlap_mm` down from its head and up from its foot.
std::vector<ClippedPass> clip_row(const std::vector<Vec3>& tips, const CellMask& wanted,
                                  const BridgeRule& rule, const SteepClip& steep);

}  // namespace limitgauge::engine::strategy
