#pragma once

#include <vector>

#include "engine/strategy/locations/cutter_locations.h"

namespace limitgauge::engine::strategy {

/// How closely a track follows the cutter location surface; lengths mm. A track lies above the
/// surface by at most `lift_mm + above_mm + reduction_mm`, and never below it.
struct TrackRule {
  double spacing_mm = 0;    ///< of the first samples: a dip narrower than this may be bridged
  double lift_mm = 0;       ///< the whole track is raised by this, so that chords may cut corners
  double above_mm = 0;      ///< chords may pass over the surface by this, along its normal
  double reduction_mm = 0;  ///< distance of points left out from the chords that replace them
  double floor_z_mm = 0;    ///< the tip never goes below
  double lowest_mm = 0;     ///< where it might sink below this, nothing to be cut is under it
};

/// The way of the tip above the straight lines from point to point of `way` (its heights are not
/// looked at), where anything is under the cutter: one run for every stretch without a gap.
///
/// Proven for every point of the track: it clears the surface, by CutterLocations::lift of every
/// chord. Sampled: how far a chord lies above the surface, at its quarter points; lengths are
/// halved until that fits, so only what is narrower than `spacing_mm` can escape. Steps in height
/// become upright pieces, found to 1e-4 mm.
std::vector<std::vector<Vec3>> track_tips(const CutterLocations& locations,
                                          const std::vector<Vec3>& way, const TrackRule& rule);

}  // namespace limitgauge::engine::strategy
