#include "verifier/surface/surface_rules.h"

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

namespace limitgauge::verifier {
namespace {

using model::Index;

std::pair<Index, Index> edge_of(Index a, Index b) {
  return {std::min(a, b), std::max(a, b)};
}

std::vector<bool> boundary_vertices(const model::Cage& cage) {
  std::map<std::pair<Index, Index>, int> uses;
  for (Index f = 0; f < cage.face_count(); ++f) {
    const auto face = cage.face(f);
    for (std::size_t k = 0; k < face.size(); ++k)
      ++uses[edge_of(face[k], face[(k + 1) % face.size()])];
  }
  std::vector<bool> out(cage.vertices.size(), false);
  for (const auto& [edge, count] : uses)
    if (count == 1) out[edge.first] = out[edge.second] = true;
  return out;
}

}  // namespace

SurfaceRules rules_of(const model::Cage& cage) {
  SurfaceRules rules;
  rules.boundary = cage.boundary;
  rules.holes = static_cast<Index>(cage.holes.size());
  // Tags may come twice: the last one of an edge or vertex counts.
  std::map<std::pair<Index, Index>, double> edges;
  for (const model::Crease& c : cage.creases)
    edges[edge_of(c.vertices[0], c.vertices[1])] = c.sharpness;
  std::map<Index, double> vertices;
  for (const model::Corner& c : cage.corners) vertices[c.vertex] = c.sharpness;
  std::map<Index, int> sharp_ends;
  for (const auto& [edge, sharpness] : edges) {
    if (sharpness >= rules.infinite_sharpness) {
      ++rules.sharp_edges;
      ++sharp_ends[edge.first], ++sharp_ends[edge.second];
    } else if (sharpness > 0) {
      ++rules.semi_sharp_edges;
    }
  }
  for (const auto& [vertex, sharpness] : vertices)
    if (sharpness > 0)
      ++(sharpness >= rules.infinite_sharpness ? rules.sharp_vertices : rules.semi_sharp_vertices);
  const std::vector<bool> on_boundary = boundary_vertices(cage);
  for (const auto& [vertex, ends] : sharp_ends) {
    const auto corner = vertices.find(vertex);
    const bool sharp = corner != vertices.end() && corner->second >= rules.infinite_sharpness;
    if (ends == 1 && !on_boundary[vertex] && !sharp) ++rules.darts;
  }
  return rules;
}

}  // namespace limitgauge::verifier
