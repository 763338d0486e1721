#include "engine/surface/cell/outer_mesh.h"

#include <algorithm>
#include <map>
#include <stdexcept>
#include <utility>

#include "engine/surface/cell/sharpness.h"

namespace limitgauge::engine::surface {
namespace {

using EdgeKey = std::pair<Index, Index>;
EdgeKey key(Index a, Index b) {
  return {std::min(a, b), std::max(a, b)};
}

void refuse_defects(const model::Cage& cage) {
  const auto defects = model::find_defects(cage);
  if (!defects.empty()) throw std::invalid_argument(model::describe(defects.front()));
}

void set_faces(OuterMesh& mesh, const model::Cage& cage) {
  mesh.points = cage.vertices;
  mesh.vertex_sharpness.assign(cage.vertices.size(), 0.0);
  mesh.face_offsets = cage.face_offsets;
  mesh.origin = cage.face_corners;
  mesh.hole.assign(static_cast<std::size_t>(cage.face_count()), 0);
  for (const Index f : cage.holes) mesh.hole[f] = 1;
  mesh.face_of.resize(mesh.origin.size());
  for (Index f = 0; f < mesh.face_count(); ++f) {
    std::fill(mesh.face_of.begin() + mesh.face_offsets[f],
              mesh.face_of.begin() + mesh.face_offsets[f + 1], f);
  }
}

/// Pairs half-edges; edges are numbered in order of their first half-edge.
std::map<EdgeKey, Index> pair_half_edges(OuterMesh& mesh) {
  std::map<EdgeKey, Index> edge_at;
  const Index count = mesh.half_edge_count();
  mesh.twin.assign(static_cast<std::size_t>(count), kNoTwin);
  mesh.edge.resize(static_cast<std::size_t>(count));
  std::vector<Index> first_half;
  for (Index h = 0; h < count; ++h) {
    const auto [at, fresh] = edge_at.try_emplace(key(mesh.origin[h], mesh.target(h)),
                                                 static_cast<Index>(first_half.size()));
    mesh.edge[h] = at->second;
    if (fresh) {
      first_half.push_back(h);
    } else {
      mesh.twin[h] = first_half[at->second];
      mesh.twin[first_half[at->second]] = h;
    }
  }
  mesh.edge_sharpness.assign(first_half.size(), 0.0);
  return edge_at;
}

/// A ring starts at the lowest half-edge, or at the clockwise boundary edge of an open ring, so
/// that every patch around a vertex computes the same numbers in the same order.
void set_ring_starts(OuterMesh& mesh) {
  mesh.first_out.assign(mesh.points.size(), kNoTwin);
  for (Index h = 0; h < mesh.half_edge_count(); ++h) {
    Index& first = mesh.first_out[mesh.origin[h]];
    if (first == kNoTwin || mesh.open(h)) first = h;
  }
}

void set_boundary_rule(OuterMesh& mesh, model::BoundaryRule rule) {
  std::vector<int> faces_at(mesh.points.size(), 0);
  std::vector<std::uint8_t> on_boundary(mesh.points.size(), 0), beside_smooth(on_boundary);
  for (Index h = 0; h < mesh.half_edge_count(); ++h) {
    ++faces_at[mesh.origin[h]];
    if (!mesh.open(h)) continue;
    double& sharpness = mesh.edge_sharpness[mesh.edge[h]];
    if (sharpness < model::kInfiniteSharpness)
      beside_smooth[mesh.origin[h]] = beside_smooth[mesh.target(h)] = 1;
    sharpness = model::kInfiniteSharpness;
    on_boundary[mesh.origin[h]] = on_boundary[mesh.target(h)] = 1;
  }
  for (Index h = 0; h < mesh.half_edge_count(); ++h) {
    const Index v = mesh.origin[h];
    if (!on_boundary[v]) continue;
    if (rule == model::BoundaryRule::none && beside_smooth[v]) mesh.hole[mesh.face_of[h]] = 1;
    if (rule == model::BoundaryRule::edge_and_corner && faces_at[v] == 1)
      mesh.vertex_sharpness[v] = model::kInfiniteSharpness;
  }
}

/// The parent mesh and its new points, for building the children.
struct Refinement {
  const OuterMesh& parent;
  std::vector<Vec3> face_points, edge_points;
};

Vec3 face_point(const OuterMesh& mesh, Index f) {
  Vec3 sum;
  for (Index h = mesh.face_offsets[f]; h < mesh.face_offsets[f + 1]; ++h)
    sum += mesh.points[mesh.origin[h]];
  return sum / static_cast<double>(mesh.face_offsets[f + 1] - mesh.face_offsets[f]);
}

Vec3 edge_point(const Refinement& r, Index h) {
  const OuterMesh& mesh = r.parent;
  const Vec3 a = mesh.points[mesh.origin[h]], b = mesh.points[mesh.target(h)];
  const Vec3 middle = (a + b) * 0.5;
  const double s = mesh.edge_sharpness[mesh.edge[h]];
  if (mesh.open(h) || s >= 1) return middle;
  const Vec3 smooth =
      (a + b + r.face_points[mesh.face_of[h]] + r.face_points[mesh.face_of[mesh.twin[h]]]) * 0.25;
  return lerp(smooth, middle, s);
}

/// Neighbours of a vertex along its edges with their sharpness, now and after the refinement.
struct Star {
  std::vector<Vec3> ends;
  std::vector<double> sharpness;
  Vec3 face_sum;
  double own_sharpness = 0;
};

Star star(const Refinement& r, Index v) {
  const OuterMesh& mesh = r.parent;
  Star s;
  s.own_sharpness = mesh.vertex_sharpness[v];
  const RingWalk walk = walk_ring(mesh, v);
  for (const Index h : walk.out) {
    s.ends.push_back(mesh.points[mesh.target(h)]);
    s.sharpness.push_back(mesh.edge_sharpness[mesh.edge[h]]);
    s.face_sum += r.face_points[mesh.face_of[h]];
  }
  if (!walk.closed) {
    const Index last = mesh.previous(walk.out.back());
    s.ends.push_back(mesh.points[mesh.origin[last]]);
    s.sharpness.push_back(mesh.edge_sharpness[mesh.edge[last]]);
  }
  return s;
}

Vec3 vertex_by_rule(const Star& s, const Vec3& v, VertexRule rule, bool child) {
  if (rule == VertexRule::corner) return v;
  Vec3 sum;
  for (std::size_t i = 0; i < s.ends.size(); ++i) {
    const double sharpness = child ? child_sharpness(s.sharpness[i]) : s.sharpness[i];
    if (rule != VertexRule::crease || is_sharp(sharpness)) sum += s.ends[i];
  }
  if (rule == VertexRule::crease) return v * 0.75 + sum * 0.125;
  const auto n = static_cast<double>(s.ends.size());
  return v * ((n - 2) / n) + (sum + s.face_sum) / (n * n);
}

Vec3 vertex_point(const Refinement& r, Index vertex) {
  const Star s = star(r, vertex);
  const Vec3 v = r.parent.points[vertex];
  int sharp = 0, child_sharp = 0, fading = 0;
  double fading_sum = 0;
  const auto count_fading = [&](double sharpness) {
    if (!is_sharp(sharpness) || is_sharp(child_sharpness(sharpness))) return;
    ++fading;
    fading_sum += sharpness;
  };
  count_fading(s.own_sharpness);
  for (const double e : s.sharpness) {
    sharp += is_sharp(e);
    child_sharp += is_sharp(child_sharpness(e));
    count_fading(e);
  }
  const VertexRule now = vertex_rule(s.own_sharpness, sharp);
  const VertexRule then = vertex_rule(child_sharpness(s.own_sharpness), child_sharp);
  const Vec3 by_now = vertex_by_rule(s, v, now, false);
  if (now == then || fading == 0) return by_now;
  const double weight = std::min(1.0, fading_sum / fading);
  return lerp(vertex_by_rule(s, v, then, true), by_now, weight);
}

void copy_child_sharpness(const OuterMesh& mesh, OuterMesh& child) {
  // Child half-edge 4c leaves vertex origin[c] along its parent half-edge c; 4c + 3 comes back to
  // it along the previous one.
  for (Index h = 0; h < mesh.half_edge_count(); ++h) {
    const double along = child_sharpness(mesh.edge_sharpness[mesh.edge[h]]);
    const double back = child_sharpness(mesh.edge_sharpness[mesh.edge[mesh.previous(h)]]);
    child.edge_sharpness[child.edge[4 * h]] = along;
    child.edge_sharpness[child.edge[4 * h + 3]] = back;
  }
}

}  // namespace

bool OuterMesh::all_quads() const {
  for (Index f = 0; f < face_count(); ++f)
    if (face_offsets[f + 1] - face_offsets[f] != 4) return false;
  return true;
}

RingWalk walk_ring(const OuterMesh& mesh, Index vertex) {
  RingWalk walk;
  const Index start = mesh.first_out[vertex];
  Index h = start;
  do {
    walk.out.push_back(h);
    const Index arriving = mesh.previous(h);
    if (mesh.open(arriving)) {
      walk.closed = false;
      return walk;
    }
    h = mesh.twin[arriving];
  } while (h != start);
  return walk;
}

OuterMesh make_outer_mesh(const model::Cage& cage) {
  refuse_defects(cage);
  OuterMesh mesh;
  set_faces(mesh, cage);
  const auto edge_at = pair_half_edges(mesh);
  set_ring_starts(mesh);
  for (const model::Crease& crease : cage.creases) {
    const auto at = edge_at.find(key(crease.vertices[0], crease.vertices[1]));
    if (at == edge_at.end()) throw std::invalid_argument("a crease names no edge of the cage");
    mesh.edge_sharpness[at->second] = crease.sharpness;
  }
  for (const model::Corner& corner : cage.corners)
    mesh.vertex_sharpness[corner.vertex] = corner.sharpness;
  set_boundary_rule(mesh, cage.boundary);
  return mesh;
}

OuterMesh refined(const OuterMesh& mesh) {
  Refinement r{mesh, {}, {}};
  const auto vertices = static_cast<Index>(mesh.points.size());
  for (Index f = 0; f < mesh.face_count(); ++f) r.face_points.push_back(face_point(mesh, f));
  r.edge_points.resize(static_cast<std::size_t>(mesh.edge_count()));
  for (Index h = 0; h < mesh.half_edge_count(); ++h)
    if (mesh.open(h) || h < mesh.twin[h]) r.edge_points[mesh.edge[h]] = edge_point(r, h);

  model::Cage quads;
  for (Index v = 0; v < vertices; ++v) quads.vertices.push_back(vertex_point(r, v));
  const Index edge_base = vertices, face_base = vertices + mesh.edge_count();
  quads.vertices.insert(quads.vertices.end(), r.edge_points.begin(), r.edge_points.end());
  quads.vertices.insert(quads.vertices.end(), r.face_points.begin(), r.face_points.end());
  for (Index h = 0; h < mesh.half_edge_count(); ++h) {
    const Index corners[] = {mesh.origin[h], edge_base + mesh.edge[h], face_base + mesh.face_of[h],
                             edge_base + mesh.edge[mesh.previous(h)]};
    quads.add_face(corners);
    if (mesh.hole[mesh.face_of[h]]) quads.holes.push_back(h);
  }
  OuterMesh child;
  set_faces(child, quads);
  pair_half_edges(child);
  set_ring_starts(child);
  copy_child_sharpness(mesh, child);
  for (Index v = 0; v < vertices; ++v)
    child.vertex_sharpness[v] = child_sharpness(mesh.vertex_sharpness[v]);
  return child;
}

}  // namespace limitgauge::engine::surface
