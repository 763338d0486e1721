#pragma once

#include <optional>
#include <span>

#include "simulator/sweep/depth_bound.h"

namespace limitgauge::simulator {

/// How near a body comes to the material.
struct Gap {
  model::Vec3 point;       ///< of the material
  double distance_mm = 0;  ///< what is left between, 0 where they touch
};

/// Moves of a cutter whose nearness excuses that of a body.
struct Excuse {
  const CutterProfile* profile = nullptr;
  std::span<const SweptMove> moves;
};

/// The least distance between `body`, swept along `move`, and the material, if it is below
/// `within_mm`. Places that a move of `excuse` comes as near to, within a tolerance, are left out.
/// Material in which no ball of half a tolerance's radius fits (crumbs between neighbouring cuts)
/// is left out; material with room for 5/8 of a tolerance never is. The place found is of the
/// material, so that the distance is never too small; it is at most a tolerance too large next to
/// faces and edges of 90 degrees. The search stops at the first place that touches.
///
/// Branch and bound: a block cannot hold a place of depth e where the distance is below d if the
/// bound of the depth in the body grown by d is below e.
std::optional<Gap> least_gap(const MaterialAtMove& material, const CutterProfile& body,
                             const SweptMove& move, double within_mm, double tolerance_mm,
                             const Excuse& excuse);

}  // namespace limitgauge::simulator
