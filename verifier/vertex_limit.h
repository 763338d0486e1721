#pragma once

#include <optional>

#include "verifier/neighbourhood.h"

namespace limitgauge::verifier {

/// Where a vertex goes in the limit, and the tangent plane there as seen from one face. No tangents
/// where no mask gives them (a dart, a corner whose sector has several faces).
struct VertexLimit {
  model::Vec3 position;
  struct Tangents {
    model::Vec3 first, second;  ///< first × second points to the machining side
  };
  std::optional<Tangents> tangents;
};

/// The limit of corner `k` of face 0. No edge or vertex there may be semi-sharp any more. Masks:
/// Halstead, Kass, DeRose 1993 (interior; the paper's equations 7 and 8 with their labels put
/// right); left eigenvectors of the refinement matrix (crease). At a dart the position is the
/// control vertex, right to the size of the neighbourhood.
VertexLimit vertex_limit(const Neighbourhood& n, int k);

}  // namespace limitgauge::verifier
