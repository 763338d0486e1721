#pragma once

#include "model/part/cage.h"

namespace limitgauge::verifier {

/// The rules that make a cage's limit surface, which other programs may read otherwise: they stand
/// in every result. The scheme is Catmull and Clark's with OpenSubdiv's rules; creases are uniform
/// (a sharpness loses one at each refinement, and what is left below one blends the rules).
struct SurfaceRules {
  model::BoundaryRule boundary = model::BoundaryRule::edge_only;
  double infinite_sharpness = model::kInfiniteSharpness;  ///< from which an edge stays sharp
  /// Tagged edges and vertices that have an effect.
  model::Index sharp_edges = 0, semi_sharp_edges = 0, sharp_vertices = 0, semi_sharp_vertices = 0;
  model::Index darts = 0;  ///< interior vertices where a single infinitely sharp edge ends
  model::Index holes = 0;
};
SurfaceRules rules_of(const model::Cage& cage);

}  // namespace limitgauge::verifier
