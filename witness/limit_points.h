#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "model/part/cage.h"

namespace limitgauge::witness {

/// A unit normal by OpenSubdiv's tangent masks.
struct LimitNormal {
  model::Vec3 along;
  /// How far it turns at most (rad) where every control point of its masks is moved by a
  /// millimetre; to first order, which holds while the turn is small.
  double turn_per_mm = 0;
};

/// A point of the limit surface by OpenSubdiv, at the parameters of a patch: quads of the cage in
/// the order of its faces, corner quads of another n-gon in the order of its corners. In mm.
struct LimitPoint {
  int patch = 0;
  double u = 0, v = 0;
  model::Vec3 position;
  bool by_mask = true;  ///< false: Far has no exact mask there, its refinement was followed
  std::optional<LimitNormal> normal;  ///< where Far's tangents are those of the surface
};

struct LimitPoints {
  std::vector<bool> has_surface;   ///< by patch: no hole, as OpenSubdiv has it
  std::vector<LimitPoint> points;  ///< of patches that have surface; each parameter once a patch
  std::size_t left_out = 0;  ///< points whose limit takes refinement, beyond what was asked for
};

/// What one refinement does to the number of points is a factor of four.
struct PointOptions {
  int levels = 4;  ///< ≥ 1
  /// Vertices whose limit is found by refinement; of more every second one, every third and so on.
  std::size_t most_refined = 4096;
};

/// OpenSubdiv's limits of the vertices that `levels` uniform refinements give, in double precision.
/// Throws CageRefused.
LimitPoints limit_points(const model::Cage& cage, const PointOptions& options);

}  // namespace limitgauge::witness
