#pragma once

#include <vector>

#include "verifier/surface/neighbourhood.h"

namespace limitgauge::verifier {

/// The faces around a vertex from one sharp edge to the next, counter-clockwise: edge[i] and
/// edge[i + 1] bound the face whose opposite corner is face[i]. Only such a sector shapes the
/// surface on this side. Without a sharp edge it is a full turn, which has as many edges as faces;
/// else it has one edge more, the first and last being the same where only one is sharp.
struct Sector {
  model::Index vertex = 0;
  std::vector<model::Index> edge, face;  ///< indices into Neighbourhood::points
  bool full_turn = false;
  int own = 0;  ///< which of the faces is the one asked for

  int faces() const { return static_cast<int>(face.size()); }
  /// Both ends are the one sharp edge of the vertex.
  bool slit() const { return !full_turn && edge.front() == edge.back(); }
};

/// The sector that holds face 0 at its corner `k`. All faces must be quads.
Sector sector_of(const Neighbourhood& n, const Star& star, int k);

/// Weights of a linear function of the vertex, edge ends and opposite corners of a sector; also
/// values at them.
struct RingWeights {
  double vertex = 0;
  std::vector<double> edge, face;
};
model::Vec3 weighted_sum(const Neighbourhood& n, const Sector& s, const RingWeights& w);

}  // namespace limitgauge::verifier
