#pragma once

#include <optional>

#include "verifier/surface/neighbourhood.h"
#include "verifier/surface/surface_sample.h"

namespace limitgauge::verifier {

/// Where a vertex goes in the limit, and the tangent plane there as seen from one face.
struct VertexLimit {
  model::Vec3 position;
  struct Tangents {
    model::Vec3 first, second;  ///< first × second points to the machining side
    TangentPlane plane = TangentPlane::everywhere;
  };
  /// None where the masks give parallel directions, as in a cage folded flat at the vertex.
  std::optional<Tangents> tangents;
};

/// The limit of corner `k` of face 0. No edge or vertex there may be semi-sharp any more, and all
/// faces are quads. What the tangent plane is, by kind of vertex and number of faces:
/// verifier/surface/TANGENTS.md, T1 to T7.
VertexLimit vertex_limit(const Neighbourhood& n, int k);

}  // namespace limitgauge::verifier
