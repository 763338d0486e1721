#pragma once

#include <span>
#include <vector>

#include "model/part/cage.h"

namespace limitgauge::verifier {

/// A face of the (refined) cage together with every face that touches it: all that the limit
/// surface over that face depends on. Face 0 is the face itself.
struct Neighbourhood {
  std::vector<model::Vec3> points;
  std::vector<double> vertex_sharpness;     ///< beside points
  std::vector<model::Index> corners;        ///< of all faces, one face after the other
  std::vector<double> edge_sharpness;       ///< beside corners: of the edge to the next corner
  std::vector<model::Index> offsets = {0};  ///< faces + 1 entries into corners

  int face_count() const { return static_cast<int>(offsets.size()) - 1; }
  int size_of(int face) const { return offsets[face + 1] - offsets[face]; }
  model::Index corner(int face, int k) const { return corners[offsets[face] + k]; }
  model::Index next(int face, int k) const {
    return corner(face, k + 1 < size_of(face) ? k + 1 : 0);
  }
  model::Index prev(int face, int k) const {
    return corner(face, k > 0 ? k - 1 : size_of(face) - 1);
  }
  double sharpness_after(int face, int k) const { return edge_sharpness[offsets[face] + k]; }
  double sharpness_before(int face, int k) const {
    return edge_sharpness[offsets[face] + (k > 0 ? k - 1 : size_of(face) - 1)];
  }
};

/// One edge at a vertex, or one face: what the vertex rules need to know of a star.
struct Star {
  struct Spoke {
    model::Index end = 0;
    double sharpness = 0;
    int faces = 0;  ///< one at a boundary
  };
  struct Wedge {
    int face = 0, corner = 0;
  };
  std::vector<Spoke> spokes;
  std::vector<Wedge> wedges;
};
/// The star of vertex `v`, complete when `v` is a corner of face 0.
Star star_of(const Neighbourhood& n, model::Index v);

/// Neighbourhoods of all faces of a cage, with boundary edges infinitely sharp and corner vertices
/// by the cage's boundary rule.
class CageNeighbourhoods {
 public:
  explicit CageNeighbourhoods(const model::Cage& cage);
  Neighbourhood of(model::Index face) const;
  /// True for faces that carry surface: no hole, and none that
  /// BoundaryRule::none leaves out.
  bool has_surface(model::Index face) const { return has_surface_[face]; }

 private:
  std::span<const model::Index> faces_at(model::Index v) const;

  const model::Cage& cage_;
  std::vector<double> vertex_sharpness_;
  std::vector<double> edge_sharpness_;  // beside cage.face_corners
  std::vector<model::Index> incident_, incident_offsets_;
  std::vector<bool> has_surface_;
};

/// One Catmull-Clark step (OpenSubdiv's rules, uniform creasing): the neighbourhood of each child
/// of face 0, one a corner. The children of a quad keep its orientation: child k lies at corner k
/// of the parameter square. The children of an n-gon have their own corner at (0, 0).
std::vector<Neighbourhood> refine(const Neighbourhood& n);

}  // namespace limitgauge::verifier
