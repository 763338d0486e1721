#pragma once

#include <cstdint>
#include <vector>

#include "model/part/cage.h"

namespace limitgauge::engine::surface {

using model::Index;
using model::Vec3;

/// No half-edge on the other side: an open boundary.
inline constexpr Index kNoTwin = -1;

/// The outer layer of CELL (paper section 3): the cage as half-edges. A half-edge is a face corner:
/// it starts at that corner and runs counter-clockwise to the next.
struct OuterMesh {
  std::vector<Vec3> points;               ///< mm
  std::vector<double> vertex_sharpness;   ///< one a vertex
  std::vector<Index> face_offsets = {0};  ///< faces + 1
  std::vector<std::uint8_t> hole;         ///< one a face: shapes the surface but is none of it
  std::vector<Index> origin;              ///< one a half-edge
  std::vector<Index> face_of;             ///< one a half-edge
  std::vector<Index> twin;                ///< one a half-edge, or kNoTwin
  std::vector<Index> edge;                ///< one a half-edge: edge id shared with the twin
  std::vector<double> edge_sharpness;     ///< one an edge; boundaries are infinitely sharp
  std::vector<Index> first_out;           ///< one a vertex: where its ring starts

  Index face_count() const { return static_cast<Index>(face_offsets.size()) - 1; }
  Index half_edge_count() const { return static_cast<Index>(origin.size()); }
  Index edge_count() const { return static_cast<Index>(edge_sharpness.size()); }
  Index next(Index h) const {
    const Index f = face_of[h];
    return h + 1 == face_offsets[f + 1] ? face_offsets[f] : h + 1;
  }
  Index previous(Index h) const {
    const Index f = face_of[h];
    return h == face_offsets[f] ? face_offsets[f + 1] - 1 : h - 1;
  }
  Index target(Index h) const { return origin[next(h)]; }
  bool open(Index h) const { return twin[h] == kNoTwin; }
  bool all_quads() const;
};

/// The half-edges that leave the vertex of a ring, counter-clockwise. An open ring starts at its
/// clockwise boundary edge; its last edge arrives at the vertex and is `closing` reversed.
struct RingWalk {
  std::vector<Index> out;
  bool closed = true;
};
RingWalk walk_ring(const OuterMesh& mesh, Index vertex);

/// Half-edges, tags and boundary rule of `cage`. Throws std::invalid_argument with the first defect
/// of a cage that is no oriented two-manifold.
OuterMesh make_outer_mesh(const model::Cage& cage);

/// One Catmull-Clark refinement of the whole mesh, tags included: turns n-gons into n quads each.
/// The children of face f follow one another, one at each of its corners in order.
OuterMesh refined(const OuterMesh& mesh);

}  // namespace limitgauge::engine::surface
