#include "tests/support/uniform_refinement.h"

#include <map>
#include <set>

namespace limitgauge::tests {
namespace {

using model::Cage;
using model::Index;
using model::Vec3;
using Edge = std::pair<Index, Index>;

Edge edge(Index a, Index b) {
  return a < b ? Edge{a, b} : Edge{b, a};
}

struct Topology {
  std::map<Edge, std::vector<Index>> edge_faces;
  std::vector<std::set<Index>> neighbours;
  std::vector<std::vector<Index>> faces_at;

  explicit Topology(const Cage& cage)
      : neighbours(cage.vertices.size()), faces_at(cage.vertices.size()) {
    for (Index f = 0; f < cage.face_count(); ++f) {
      const auto c = cage.face(f);
      for (std::size_t k = 0; k < c.size(); ++k) {
        const Index a = c[k], b = c[(k + 1) % c.size()];
        edge_faces[edge(a, b)].push_back(f);
        neighbours[a].insert(b), neighbours[b].insert(a);
        faces_at[a].push_back(f);
      }
    }
  }
  std::vector<Index> boundary_neighbours(Index v) const {
    std::vector<Index> out;
    for (const Index n : neighbours[v])
      if (edge_faces.at(edge(v, n)).size() == 1) out.push_back(n);
    return out;
  }
};

bool fixed_corner(const Cage& cage, const Topology& t, Index v) {
  return cage.boundary == model::BoundaryRule::edge_and_corner && t.faces_at[v].size() == 1;
}

Vec3 centroid(const Cage& cage, Index f) {
  Vec3 sum;
  for (const Index v : cage.face(f)) sum += cage.vertices[v];
  return sum / static_cast<double>(cage.face(f).size());
}

Vec3 vertex_point(const Cage& cage, const Topology& t, Index v) {
  const Vec3& p = cage.vertices[v];
  const auto rim = t.boundary_neighbours(v);
  if (fixed_corner(cage, t, v)) return p;
  if (!rim.empty()) return p * 0.75 + (cage.vertices[rim[0]] + cage.vertices[rim[1]]) * 0.125;
  const double n = static_cast<double>(t.neighbours[v].size());
  Vec3 edges, faces;
  for (const Index e : t.neighbours[v]) edges += cage.vertices[e];
  for (const Index f : t.faces_at[v]) faces += centroid(cage, f);
  return (faces / n + (edges / n + p) + p * (n - 3)) / n;
}

Vec3 limit_position(const Cage& cage, const Topology& t, Index v) {
  const Vec3& p = cage.vertices[v];
  if (fixed_corner(cage, t, v)) return p;
  const auto rim = t.boundary_neighbours(v);
  if (!rim.empty()) return (p * 4 + cage.vertices[rim[0]] + cage.vertices[rim[1]]) / 6;
  const double n = static_cast<double>(t.neighbours[v].size());
  Vec3 edges, diagonals;
  for (const Index e : t.neighbours[v]) edges += cage.vertices[e];
  for (const Index f : t.faces_at[v]) {
    const auto c = cage.face(f);
    for (std::size_t k = 0; k < 4; ++k)
      if (c[k] == v) diagonals += cage.vertices[c[(k + 2) % 4]];
  }
  return (p * (n * n) + edges * 4 + diagonals) / (n * (n + 5));
}

}  // namespace

Cage refine_uniformly(const Cage& cage) {
  const Topology t(cage);
  Cage out;
  out.boundary = cage.boundary;
  for (std::size_t v = 0; v < cage.vertices.size(); ++v)
    out.vertices.push_back(vertex_point(cage, t, static_cast<Index>(v)));
  std::map<Edge, Index> edge_point;
  for (const auto& [e, faces] : t.edge_faces) {
    edge_point[e] = static_cast<Index>(out.vertices.size());
    Vec3 sum = cage.vertices[e.first] + cage.vertices[e.second];
    if (faces.size() == 2) sum = (sum + centroid(cage, faces[0]) + centroid(cage, faces[1])) * 0.5;
    out.vertices.push_back(sum * 0.5);
  }
  for (Index f = 0; f < cage.face_count(); ++f) {
    const auto middle = static_cast<Index>(out.vertices.size());
    out.vertices.push_back(centroid(cage, f));
    const auto c = cage.face(f);
    for (std::size_t k = 0; k < c.size(); ++k) {
      const Index next = c[(k + 1) % c.size()], prev = c[(k + c.size() - 1) % c.size()];
      out.add_face(std::array<Index, 4>{c[k], edge_point[edge(c[k], next)], middle,
                                        edge_point[edge(c[k], prev)]});
    }
  }
  return out;
}

std::vector<Vec3> limit_positions(const Cage& cage) {
  const Topology t(cage);
  std::vector<Vec3> out;
  for (std::size_t v = 0; v < cage.vertices.size(); ++v)
    out.push_back(limit_position(cage, t, static_cast<Index>(v)));
  return out;
}

}  // namespace limitgauge::tests
