#include "model/part/cage.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "model/base/angle.h"
#include "model/part/cage_edges.h"

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

}  // namespace limitgauge::model
