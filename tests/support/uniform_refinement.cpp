#include "tests/support/uniform_refinement.h"

#include <cmath>
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

/// OpenSubdiv: ten and more is infinite, and stays so; less falls by one down to zero.
double next_sharpness(double s) {
  if (s >= 10) return 10;
  return std::fmax(0, s - 1);
}
bool lasting(double s) {
  return s <= 0 || s >= 10;
}

struct Topology {
  std::map<Edge, std::vector<Index>> edge_faces;
  std::map<Edge, double> crease;
  std::map<Index, double> corner;
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
    for (const model::Crease& c : cage.creases)
      crease[edge(c.vertices[0], c.vertices[1])] = c.sharpness;
    for (const auto& [e, faces] : edge_faces)
      if (faces.size() == 1) crease[e] = 10;
    for (const model::Corner& c : cage.corners) corner[c.vertex] = c.sharpness;
    if (cage.boundary != model::BoundaryRule::edge_and_corner) return;
    for (Index v = 0; v < static_cast<Index>(cage.vertices.size()); ++v)
      if (faces_at[v].size() == 1 && neighbours[v].size() == 2) corner[v] = 10;
  }
  double sharpness(Index a, Index b) const {
    const auto at = crease.find(edge(a, b));
    return at == crease.end() ? 0 : at->second;
  }
  double vertex_sharpness(Index v) const {
    const auto at = corner.find(v);
    return at == corner.end() ? 0 : at->second;
  }
  bool on_boundary(Index v) const { return faces_at[v].size() < neighbours[v].size(); }
};

Vec3 centroid(const Cage& cage, Index f) {
  Vec3 sum;
  for (const Index v : cage.face(f)) sum += cage.vertices[v];
  return sum / static_cast<double>(cage.face(f).size());
}

Vec3 edge_point(const Cage& cage, const Topology& t, Edge e) {
  const Vec3 middle = (cage.vertices[e.first] + cage.vertices[e.second]) * 0.5;
  const double s = t.sharpness(e.first, e.second);
  if (s >= 1) return middle;
  const auto& faces = t.edge_faces.at(e);
  const Vec3 smooth = (middle + (centroid(cage, faces[0]) + centroid(cage, faces[1])) * 0.5) * 0.5;
  return smooth * (1 - s) + middle * s;
}

Vec3 smooth_vertex(const Cage& cage, const Topology& t, Index v) {
  const double n = static_cast<double>(t.neighbours[v].size());
  Vec3 edges, faces;
  for (const Index e : t.neighbours[v]) edges += cage.vertices[e];
  for (const Index f : t.faces_at[v]) faces += centroid(cage, f);
  return (faces / n + edges / n + cage.vertices[v] * (n - 2)) / n;
}

/// The new position if the sharpnesses were as `sharp` says.
struct Sharp {
  bool vertex = false;
  std::vector<Index> ends;

  bool operator==(const Sharp& b) const {
    const auto rank = [](const Sharp& s) {
      return s.vertex || s.ends.size() > 2 ? 2 : s.ends.size() == 2 ? 1 : 0;
    };
    return rank(*this) == rank(b);
  }
};
Vec3 moved(const Cage& cage, const Topology& t, Index v, const Sharp& sharp) {
  const Vec3& p = cage.vertices[v];
  if (sharp.vertex || sharp.ends.size() > 2) return p;
  if (sharp.ends.size() == 2)
    return p * 0.75 + (cage.vertices[sharp.ends[0]] + cage.vertices[sharp.ends[1]]) * 0.125;
  return smooth_vertex(cage, t, v);
}

Vec3 vertex_point(const Cage& cage, const Topology& t, Index v) {
  Sharp parent, child;
  double running_out = 0, count = 0;
  const auto look = [&](double s) {
    if (s > 0 && next_sharpness(s) <= 0) running_out += s, count += 1;
    return s > 0;
  };
  const double own = t.vertex_sharpness(v);
  parent.vertex = look(own), child.vertex = next_sharpness(own) > 0;
  for (const Index n : t.neighbours[v]) {
    const double s = t.sharpness(v, n);
    if (look(s)) parent.ends.push_back(n);
    if (next_sharpness(s) > 0) child.ends.push_back(n);
  }
  const Vec3 now = moved(cage, t, v, parent);
  if (parent == child) return now;
  const double share = count > 0 ? std::fmin(1, running_out / count) : 0;
  return now * share + moved(cage, t, v, child) * (1 - share);
}

/// Ends of edges and far corners around a dart, the sharp edge first, in order.
struct Ring {
  Vec3 vertex;
  std::vector<Vec3> ends, far;
};
Ring ring_of(const Cage& cage, const Topology& t, Index v, Index sharp_end) {
  Ring ring{cage.vertices[v], {}, {}};
  for (Index end = sharp_end; ring.ends.size() < t.neighbours[v].size();) {
    ring.ends.push_back(cage.vertices[end]);
    for (const Index f : t.faces_at[v]) {
      const auto c = cage.face(f);
      std::size_t k = 0;
      while (c[k] != v) ++k;
      if (c[(k + 1) % 4] != end) continue;
      ring.far.push_back(cage.vertices[c[(k + 2) % 4]]);
      end = c[(k + 3) % 4];
      break;
    }
  }
  return ring;
}

Vec3 dart_limit(Ring r) {
  const std::size_t n = r.ends.size();
  for (int step = 0; step < 200; ++step) {  // 0.66^200: below any rounding
    Ring next{{}, r.ends, r.far};
    for (std::size_t i = 0; i < n; ++i)
      next.far[i] = (r.vertex + r.ends[i] + r.ends[(i + 1) % n] + r.far[i]) / 4;
    next.ends[0] = (r.vertex + r.ends[0]) / 2;
    for (std::size_t i = 1; i < n; ++i)
      next.ends[i] = (r.vertex + r.ends[i] + next.far[i - 1] + next.far[i]) / 4;
    Vec3 around;
    for (std::size_t i = 0; i < n; ++i) around += r.ends[i] + next.far[i];
    const double valence = static_cast<double>(n);
    next.vertex = (around / valence + r.vertex * (valence - 2)) / valence;
    r = next;
  }
  return r.vertex;
}

std::optional<Vec3> limit_position(const Cage& cage, const Topology& t, Index v) {
  const Vec3& p = cage.vertices[v];
  std::vector<Index> sharp;
  if (!lasting(t.vertex_sharpness(v))) return std::nullopt;
  for (const Index n : t.neighbours[v]) {
    if (!lasting(t.sharpness(v, n))) return std::nullopt;
    if (t.sharpness(v, n) > 0) sharp.push_back(n);
  }
  if (t.vertex_sharpness(v) > 0 || sharp.size() > 2) return p;
  if (sharp.size() == 2) return (p * 4 + cage.vertices[sharp[0]] + cage.vertices[sharp[1]]) / 6;
  if (sharp.size() == 1) return dart_limit(ring_of(cage, t, v, sharp[0]));
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

VertexClass class_of(const Topology& t, Index v) {
  using Kind = VertexClass::Kind;
  const int faces = static_cast<int>(t.faces_at[v].size());
  int sharp = 0;
  bool semi = !lasting(t.vertex_sharpness(v));
  for (const Index n : t.neighbours[v]) {
    sharp += t.sharpness(v, n) > 0;
    semi = semi || !lasting(t.sharpness(v, n));
  }
  if (semi) return {Kind::semi_sharp, faces};
  if (t.vertex_sharpness(v) > 0 || sharp > 2) return {Kind::corner, faces};
  if (t.on_boundary(v)) return {Kind::boundary, faces};
  if (sharp == 2) return {Kind::crease, faces};
  return {sharp == 1 ? Kind::dart : Kind::interior, faces};
}

void hand_down_tags(const Cage& cage, const Topology& t, const std::map<Edge, Index>& edge_child,
                    Cage& out) {
  for (const auto& [e, s] : t.crease) {
    const double left = next_sharpness(s);
    if (left <= 0 || !t.edge_faces.contains(e) || t.edge_faces.at(e).size() == 1) continue;
    out.creases.push_back({{e.first, edge_child.at(e)}, left});
    out.creases.push_back({{e.second, edge_child.at(e)}, left});
  }
  for (const model::Corner& c : cage.corners)
    if (next_sharpness(c.sharpness) > 0)
      out.corners.push_back({c.vertex, next_sharpness(c.sharpness)});
}

}  // namespace

Cage refine_uniformly(const Cage& cage) {
  const Topology t(cage);
  const std::set<Index> holes(cage.holes.begin(), cage.holes.end());
  Cage out;
  out.boundary = cage.boundary;
  for (std::size_t v = 0; v < cage.vertices.size(); ++v)
    out.vertices.push_back(t.faces_at[v].empty() ? cage.vertices[v]
                                                 : vertex_point(cage, t, static_cast<Index>(v)));
  std::map<Edge, Index> edge_child;
  for (const auto& [e, faces] : t.edge_faces) {
    edge_child[e] = static_cast<Index>(out.vertices.size());
    out.vertices.push_back(edge_point(cage, t, e));
  }
  for (Index f = 0; f < cage.face_count(); ++f) {
    const auto middle = static_cast<Index>(out.vertices.size());
    out.vertices.push_back(centroid(cage, f));
    const auto c = cage.face(f);
    for (std::size_t k = 0; k < c.size(); ++k) {
      const Index next = c[(k + 1) % c.size()], prev = c[(k + c.size() - 1) % c.size()];
      if (holes.contains(f)) out.holes.push_back(out.face_count());
      out.add_face(std::array<Index, 4>{c[k], edge_child[edge(c[k], next)], middle,
                                        edge_child[edge(c[k], prev)]});
    }
  }
  hand_down_tags(cage, t, edge_child, out);
  return out;
}

std::vector<std::optional<Vec3>> limit_positions(const Cage& cage) {
  const Topology t(cage);
  std::vector<std::optional<Vec3>> out;
  for (std::size_t v = 0; v < cage.vertices.size(); ++v)
    out.push_back(t.faces_at[v].empty() ? std::nullopt
                                        : limit_position(cage, t, static_cast<Index>(v)));
  return out;
}

std::vector<VertexClass> vertex_classes(const Cage& cage) {
  const Topology t(cage);
  std::vector<VertexClass> out;
  for (std::size_t v = 0; v < cage.vertices.size(); ++v)
    out.push_back(class_of(t, static_cast<Index>(v)));
  return out;
}

}  // namespace limitgauge::tests
