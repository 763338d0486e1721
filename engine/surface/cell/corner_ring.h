#pragma once

#include <vector>

#include "engine/surface/cell/outer_mesh.h"
#include "engine/surface/cell/sharpness.h"
#include "model/geometry/vec3.h"

namespace limitgauge::engine::surface {

/// The neighbourhood A_v of a patch corner (paper figure 2): the vertex, its edge neighbours
/// counter-clockwise and the diagonal neighbours between them. It refines by itself, so it reaches
/// any depth, and it carries the tags of its edges. An open ring has one face less than edges.
class CornerRing {
 public:
  /// What a ring is made of, counter-clockwise; see the class.
  struct Parts {
    Vec3 centre;
    std::vector<Vec3> edges, faces;
    std::vector<double> sharpness;  ///< one an edge
    bool closed = true;
    int own = 0;  ///< the edge with which the patch's face begins
  };
  /// A ring inside a refined patch, away from tags of vertices.
  explicit CornerRing(Parts parts);
  /// The ring of the corner at which half-edge `corner` of a quad mesh starts.
  CornerRing(const OuterMesh& mesh, Index corner);

  /// One refinement of vertex, edge and face points (OpenSubdiv's uniform crease rules).
  void refine();

  const Vec3& centre() const { return centre_; }
  /// Edge neighbour `offset` steps counter-clockwise of the patch's own outgoing edge.
  const Vec3& edge_beyond(int offset) const { return edges_[wrapped(own_ + offset)]; }

  /// The diagonal neighbour in face `offset`, counted from the patch's own.
  const Vec3& face_beyond(int offset) const {
    return faces_[static_cast<std::size_t>(own_ + offset) % faces_.size()];
  }
  /// Appends the points of the ring to `points`.
  void add_points(std::vector<Vec3>& points) const;
  /// Whether the surface beside the vertex is one bicubic a face: an inner vertex of four smooth
  /// faces, two faces along a crease or boundary, or one in a sharp corner.
  bool regular() const;

  /// As allocated.
  std::size_t memory_bytes() const {
    return sizeof(*this) + (edges_.capacity() + faces_.capacity()) * sizeof(Vec3) +
           sharpness_.capacity() * sizeof(double);
  }

  /// Largest sharpness that refinement will use up: limits hold only once it is zero.
  double largest_finite_sharpness() const;
  VertexRule rule() const { return rule_of(false); }
  /// Whether the surface turns sharply here: no single normal around the vertex.
  bool is_sharp_point() const;

  /// Limit position (equation 7 corrected; creases (1 4 1)/6; corners stay; darts by iteration).
  Vec3 limit_point() const;
  /// Unit limit normal of the smooth sector that holds the patch (equation 8; Biermann, Levin and
  /// Zorin's masks at creases).
  Vec3 limit_normal() const;

 private:
  struct Sector {
    int first = 0;  ///< edge at its clockwise end
    int faces = 0;
  };
  struct DeepLimit {
    Vec3 point, normal;
  };

  int edge_total() const { return static_cast<int>(edges_.size()); }
  int face_total() const { return static_cast<int>(faces_.size()); }
  std::size_t wrapped(int i) const {
    return static_cast<std::size_t>((i % edge_total() + edge_total()) % edge_total());
  }
  VertexRule rule_of(bool child) const;
  Vec3 moved_by(VertexRule rule, bool child) const;
  Vec3 refined_centre() const;
  Vec3 refined_edge(int i) const;
  Sector own_sector() const;
  Vec3 smooth_normal() const;
  Vec3 crease_normal(const Sector& sector) const;
  Vec3 corner_normal(const Sector& sector) const;
  Vec3 sector_cross(const Sector& sector) const;
  DeepLimit deep_limit() const;

  Vec3 centre_;
  std::vector<Vec3> edges_, faces_;
  std::vector<double> sharpness_;
  double own_sharpness_ = 0;
  bool closed_ = true;
  int own_ = 0;  ///< the edge with which the patch's face begins
};

}  // namespace limitgauge::engine::surface
