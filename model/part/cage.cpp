#include "model/part/cage.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <tuple>

#include "model/base/angle.h"

namespace limitgauge::model {
namespace {

/// Figures of the neighbourhood of every vertex.
struct VertexStar {
  Index edges = 0, faces = 0;
  bool boundary = false;
};

std::vector<VertexStar> vertex_stars(const Cage& cage, Index& boundary_edges) {
  std::vector<VertexStar> stars(cage.vertices.size());
  for (const Index v : cage.face_corners) ++stars[v].faces;
  for_each_edge(sorted_edge_uses(cage), [&](std::span<const EdgeUse> uses) {
    for (const Index v : {uses[0].low, uses[0].high}) {
      ++stars[v].edges;
      if (uses.size() == 1) stars[v].boundary = true;
    }
    if (uses.size() == 1) ++boundary_edges;
  });
  return stars;
}

bool is_extraordinary(const VertexStar& star) {
  return star.boundary ? star.faces > 2 : star.edges != 4;
}

std::vector<std::array<Index, 2>> table(const std::map<Index, Index>& counts) {
  std::vector<std::array<Index, 2>> rows;
  for (const auto& [value, count] : counts) rows.push_back({value, count});
  return rows;
}

}  // namespace

std::vector<EdgeUse> sorted_edge_uses(const Cage& cage) {
  std::vector<EdgeUse> uses;
  uses.reserve(cage.face_corners.size());
  for (Index f = 0; f < cage.face_count(); ++f) {
    const Index begin = cage.face_offsets[f], end = cage.face_offsets[f + 1];
    for (Index c = begin; c < end; ++c) {
      const Index next = c + 1 < end ? c + 1 : begin;
      const auto [low, high] = std::minmax(cage.face_corners[c], cage.face_corners[next]);
      uses.push_back({low, high, c, next, f});
    }
  }
  std::sort(uses.begin(), uses.end(), [](const EdgeUse& a, const EdgeUse& b) {
    return std::tie(a.low, a.high, a.corner) < std::tie(b.low, b.high, b.corner);
  });
  return uses;
}

Cage placed(const Cage& cage, const Placement& placement) {
  Cage moved = cage;
  const auto [c, s] = direction(placement.rotate_z_deg);
  for (Vec3& p : moved.vertices) {
    const Vec3 q = p * placement.scale;
    p = Vec3{c * q.x - s * q.y, s * q.x + c * q.y, q.z} + placement.translate_mm;
  }
  return moved;
}

CageSummary summarize(const Cage& cage) {
  CageSummary summary;
  summary.faces = cage.face_count();
  summary.creases = static_cast<Index>(cage.creases.size());
  summary.corners = static_cast<Index>(cage.corners.size());
  summary.holes = static_cast<Index>(cage.holes.size());
  std::map<Index, Index> sizes, interior, boundary;
  for (Index f = 0; f < cage.face_count(); ++f) {
    const Index size = static_cast<Index>(cage.face(f).size());
    ++sizes[size];
    summary.patches += size == 4 ? 1 : size;
  }
  for (const VertexStar& star : vertex_stars(cage, summary.boundary_edges)) {
    if (star.faces == 0) continue;
    ++summary.vertices;
    ++(star.boundary ? boundary : interior)[star.edges];
    if (is_extraordinary(star)) ++summary.extraordinary_vertices;
  }
  summary.face_sizes = table(sizes);
  summary.interior_valences = table(interior);
  summary.boundary_valences = table(boundary);
  return summary;
}

namespace {

using Kind = CageDefect::Kind;

/// Disjoint sets of corners, joined where two faces meet along an edge of the corner's vertex.
class Fans {
 public:
  explicit Fans(std::size_t corners) : parent_(corners) {
    std::iota(parent_.begin(), parent_.end(), Index{0});
  }
  Index root(Index corner) {
    while (parent_[corner] != corner) corner = parent_[corner] = parent_[parent_[corner]];
    return corner;
  }
  /// The smaller root wins, so that a fan is known by its first corner.
  void join(Index a, Index b) {
    const auto [low, high] = std::minmax({root(a), root(b)});
    parent_[high] = low;
  }

 private:
  std::vector<Index> parent_;
};

/// The vertex that makes face `f` degenerate; what `seen` holds decides, face by face.
std::vector<Index> degenerate_vertices(const Cage& cage, Index f, std::vector<Index>& seen) {
  const std::span<const Index> face = cage.face(f);
  if (face.size() < 3) return {face.begin(), face.end()};
  for (const Index v : face) {
    if (v < 0 || v >= static_cast<Index>(cage.vertices.size()) || seen[v] == f) return {v};
    seen[v] = f;
  }
  return {};
}

std::vector<CageDefect> degenerate_faces(const Cage& cage) {
  std::vector<CageDefect> found;
  std::vector<Index> seen(cage.vertices.size(), Index{-1});
  for (Index f = 0; f < cage.face_count(); ++f) {
    std::vector<Index> vertices = degenerate_vertices(cage, f, seen);
    if (!vertices.empty() || cage.face(f).size() < 3)
      found.push_back({Kind::degenerate_face, f, std::move(vertices)});
  }
  return found;
}

Index corner_at(const Cage& cage, const EdgeUse& use, Index vertex) {
  return cage.face_corners[use.corner] == vertex ? use.corner : use.next_corner;
}

/// Adds what is wrong with one edge, and joins the fans on both its ends.
void check_edge(const Cage& cage, std::span<const EdgeUse> uses, Fans& fans,
                std::vector<CageDefect>& found) {
  const Index low = uses[0].low, high = uses[0].high;
  if (uses.size() > 2) found.push_back({Kind::non_manifold_edge, uses[2].face, {low, high}});
  if (uses.size() == 2 && cage.face_corners[uses[0].corner] == cage.face_corners[uses[1].corner])
    found.push_back({Kind::flipped_face, uses[1].face, {low, high}});
  for (const EdgeUse& use : uses.subspan(1)) {
    for (const Index v : {low, high})
      fans.join(corner_at(cage, uses[0], v), corner_at(cage, use, v));
  }
}

void check_vertices(const Cage& cage, Fans& fans, std::vector<CageDefect>& found) {
  constexpr Index kNoFan = -1, kReported = -2;
  std::vector<Index> fan_of(cage.vertices.size(), kNoFan);
  for (Index f = 0; f < cage.face_count(); ++f) {
    for (Index c = cage.face_offsets[f]; c < cage.face_offsets[f + 1]; ++c) {
      Index& fan = fan_of[cage.face_corners[c]];
      if (fan == kNoFan) fan = fans.root(c);
      if (fan == kReported || fan == fans.root(c)) continue;
      found.push_back({Kind::non_manifold_vertex, f, {cage.face_corners[c]}});
      fan = kReported;
    }
  }
}

std::string list(const std::vector<Index>& vertices) {
  std::string text;
  for (const Index v : vertices) text += (text.empty() ? "" : " and ") + std::to_string(v + 1);
  return text;
}

}  // namespace

std::vector<CageDefect> find_defects(const Cage& cage) {
  std::vector<CageDefect> found = degenerate_faces(cage);
  if (!found.empty()) return found;
  Fans fans(cage.face_corners.size());
  for_each_edge(sorted_edge_uses(cage),
                [&](std::span<const EdgeUse> uses) { check_edge(cage, uses, fans, found); });
  check_vertices(cage, fans, found);
  std::stable_sort(found.begin(), found.end(),
                   [](const CageDefect& a, const CageDefect& b) { return a.face < b.face; });
  return found;
}

std::string describe(const CageDefect& defect) {
  const std::string face = "face " + std::to_string(defect.face + 1);
  switch (defect.kind) {
    case Kind::non_manifold_edge:
      return face + " is the third at the edge between vertices " + list(defect.vertices);
    case Kind::non_manifold_vertex:
      return face + " meets the faces before it at vertex " + list(defect.vertices) +
             " in a point only";
    case Kind::flipped_face:
      return face + " turns the other way than its neighbour across the edge between vertices " +
             list(defect.vertices);
    case Kind::degenerate_face:
      return face + " has fewer than three corners, or a vertex twice or out of range (vertices: " +
             list(defect.vertices) + ")";
  }
  return face;
}

Cage turned(Cage cage, const Pose& pose) {
  for (Vec3& p : cage.vertices) p = pose.point(p);
  return cage;
}

}  // namespace limitgauge::model
