#pragma once

#include <optional>

#include "verifier/surface/neighbourhood.h"
#include "verifier/surface/reference_surface.h"

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
/// faces are quads. λ are the eigenvalues of the refinement of the sector (see ring_modes.h), n or
/// m the number of faces in it. What follows from them:
///
/// - smooth, n ≥ 3: the plane of the two waves (Halstead, Kass, DeRose 1993; equations 7 and 8
///   there with their labels put right). n = 2: three directions shrink by 1/4 a refinement, one of
///   them changing sign each time, so there is no tangent plane; the mean one is given.
/// - dart: the plane of the symmetric and the antisymmetric direction; λ both above the rest for
///   all n ≥ 3.
/// - crease, m ≤ 4: the plane of the crease (λ = 1/2) and of the first wave. For m = 1 the second
///   direction and for m = 4 the crease's shrink as k·λ^k: defective eigenvalues, the plane is
///   approached like 1/k. m ≥ 5: the first two waves shrink less than the crease does, their plane
///   is the limit along every direction but the crease itself: not C1, which is why Biermann, Levin
///   and Zorin changed the rules.
/// - corner, m = 1: the two edges; m = 2: the two edges, approached like 1/k; m = 3: the first wave
///   shrinks least and both edges alike, so that the plane turns with the direction; m = 4: first
///   wave and difference of the edges, m ≥ 5: first two waves, along every direction but the edges.
/// - corner without sharp edges: a spike, whose normals turn all the way around its axis.
VertexLimit vertex_limit(const Neighbourhood& n, int k);

}  // namespace limitgauge::verifier
