#pragma once

#include <optional>
#include <vector>

#include "engine/strategy/linking/cut_pass.h"
#include "engine/strategy/locations/cutter_locations.h"
#include "engine/strategy/stage_path.h"

namespace limitgauge::engine::strategy {

/// Way of the tip from above to the start of a pass, or away from its end.
struct Approach {
  std::vector<model::Vec3> tips;  ///< the start or end of the pass is one end of it
  bool ramps = false;             ///< goes down into standing material: at the plunge feed
  /// Height of the first tip over what stands there; nothing where it stands on the surface.
  bool begins_in_air = false;
};

/// What approaches must keep to.
struct ApproachRule {
  const CutterLocations& locations;
  const StageRequest& request;
  /// Heights above standing material at which a cutter goes down at the plunge feed, mm.
  double air_mm = 0;

  /// How far `tip` itself is below the location surface, mm: links that end there cannot do better.
  double slack_at(const model::Vec3& tip) const;
  bool clears(const std::vector<model::Vec3>& tips, double slack_mm) const;
};

/// The way into a pass: an entry by CutOptions::entry where material stands, else a lead-in tangent
/// to the pass. Proven clear, but for what the pass's first tip itself lacks. `tips` are in the
/// order of cutting, closed ones with their first tip again at the end.
Approach way_in(const ApproachRule& rule, const CutPass& pass,
                const std::vector<model::Vec3>& tips);
/// Lead-out, from the last tip on; that tip alone where none is clear.
Approach way_out(const ApproachRule& rule, const std::vector<model::Vec3>& tips);

/// A zigzag of ramps along the pass that ends at its first tip, from `depth_mm` above it, nowhere
/// steeper than the ramp angle; nothing where none is clear.
std::optional<std::vector<model::Vec3>> ramp_along(const ApproachRule& rule,
                                                   const std::vector<model::Vec3>& tips,
                                                   double depth_mm);
/// A helix that ends at the first tip, tangent to the pass; nothing where none is clear.
std::optional<std::vector<model::Vec3>> helix_to(const ApproachRule& rule,
                                                 const std::vector<model::Vec3>& tips,
                                                 double depth_mm);

}  // namespace limitgauge::engine::strategy
