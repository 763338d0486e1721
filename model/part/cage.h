#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "model/geometry/pose.h"

namespace limitgauge::model {

using Index = std::int32_t;

/// How the limit surface ends at an open boundary (OpenSubdiv's names and numbers).
/// `none`: faces with a boundary vertex are no surface, unless all boundary edges at it are sharp;
/// `edge_and_corner`: boundary curve interpolates corners of one face; `edge_only`: such corners
/// are rounded.
enum class BoundaryRule { none = 0, edge_and_corner = 1, edge_only = 2 };

/// Sharpness from which a crease or corner is infinitely sharp.
inline constexpr double kInfiniteSharpness = 10.0;

struct Crease {
  std::array<Index, 2> vertices{};
  double sharpness = 0;
};

struct Corner {
  Index vertex = 0;
  double sharpness = 0;
};

/// The control mesh of a Catmull-Clark surface: faces of three or more corners, counter-clockwise
/// seen from the machining side, in the order of the file. Positions in mm.
struct Cage {
  std::string name;
  std::vector<Vec3> vertices;
  std::vector<Index> face_corners;        ///< corners of all faces, one face after the other
  std::vector<Index> face_offsets = {0};  ///< faces + 1 entries into face_corners
  std::vector<Crease> creases;
  std::vector<Corner> corners;
  std::vector<Index> holes;  ///< faces that are no surface but shape it
  BoundaryRule boundary = BoundaryRule::edge_only;
  bool ends_in_line = true;  ///< false: the file's last line has no end, it may have been cut off

  Index face_count() const { return static_cast<Index>(face_offsets.size()) - 1; }
  std::span<const Index> face(Index f) const {
    return std::span(face_corners).subspan(face_offsets[f], face_offsets[f + 1] - face_offsets[f]);
  }
  void add_face(std::span<const Index> corners_ccw) {
    face_corners.insert(face_corners.end(), corners_ccw.begin(), corners_ccw.end());
    face_offsets.push_back(static_cast<Index>(face_corners.size()));
  }
};

/// A similarity of the cage: scale about the origin, rotate about Z, then translate.
struct Placement {
  double scale = 1;
  double rotate_z_deg = 0;
  Vec3 translate_mm;
};
/// The cage moved by `placement`; a rotation by a multiple of 90° is exact.
Cage placed(const Cage& cage, const Placement& placement);
/// The cage moved by `pose`: its limit surface moves with it.
Cage turned(Cage cage, const Pose& pose);

/// Topology figures of a cage, as `inspect` and result.json show them. Vertices that no face has do
/// not count. `patches` is the number of quads after n-gons have been split: one for a quad, n for
/// another n-gon, holes included. A vertex's valence is the number of its edges. Extraordinary are
/// interior vertices of a valence other than 4 and boundary vertices of more than two faces.
/// All indices of the cage must be in range, as in a cage that was read or has no defects.
struct CageSummary {
  Index vertices = 0, faces = 0, patches = 0, boundary_edges = 0, extraordinary_vertices = 0;
  Index creases = 0, corners = 0, holes = 0;
  std::vector<std::array<Index, 2>> face_sizes;         ///< (corners, how many), ascending
  std::vector<std::array<Index, 2>> interior_valences;  ///< (valence, how many), ascending
  std::vector<std::array<Index, 2>> boundary_valences;  ///< (valence, how many), ascending
};
CageSummary summarize(const Cage& cage);

/// A defect that makes the cage no two-manifold with consistent orientation.
struct CageDefect {
  enum class Kind { non_manifold_edge, non_manifold_vertex, flipped_face, degenerate_face };
  Kind kind{};
  Index face = 0;               ///< the face where it was met
  std::vector<Index> vertices;  ///< the vertices concerned
};
/// All defects, in order of faces; empty for a usable cage. Where faces are degenerate (fewer than
/// three corners, a vertex twice or out of range), only those are reported. An edge of more than
/// two faces is met at its third, one that two faces run through the same way at the second, a
/// vertex where faces meet in a point only at the first face that does so.
std::vector<CageDefect> find_defects(const Cage& cage);
/// One line for people; faces and vertices count from 1, as in OBJ files.
std::string describe(const CageDefect& defect);

/// One face's use of an edge: from the vertex of `corner` (an index into Cage::face_corners) to the
/// next corner of `face`. `low` and `high` are the two vertices in ascending order.
struct EdgeUse {
  Index low = 0, high = 0;
  Index corner = 0, next_corner = 0;
  Index face = 0;

  friend bool operator==(const EdgeUse&, const EdgeUse&) = default;
};

/// The uses of all edges of a cage whose indices are in range, those of one edge side by side and
/// in the order of the faces.
std::vector<EdgeUse> sorted_edge_uses(const Cage& cage);

/// Calls `visit(std::span<const EdgeUse>)` once an edge.
template <typename Visit>
void for_each_edge(std::span<const EdgeUse> uses, Visit&& visit) {
  for (std::size_t begin = 0, end = 0; begin < uses.size(); begin = end) {
    while (end < uses.size() && uses[end].low == uses[begin].low &&
           uses[end].high == uses[begin].high)
      ++end;
    visit(uses.subspan(begin, end - begin));
  }
}

}  // namespace limitgauge::model
