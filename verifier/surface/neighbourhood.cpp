#include "verifier/surface/neighbourhood.h"

#include <algorithm>
#include <limits>
#include <map>

namespace limitgauge::verifier {

using model::Cage;
using model::Index;

namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

double effective(double sharpness) {
  return sharpness >= model::kInfiniteSharpness ? kInfinite : sharpness;
}

using EdgeKey = std::pair<Index, Index>;
EdgeKey edge_key(Index a, Index b) {
  return {std::min(a, b), std::max(a, b)};
}

}  // namespace

Star star_of(const Neighbourhood& n, Index v) {
  Star star;
  const auto add_spoke = [&](Index end, double sharpness) {
    for (Star::Spoke& spoke : star.spokes)
      if (spoke.end == end) {
        ++spoke.faces;
        return;
      }
    star.spokes.push_back({end, sharpness, 1});
  };
  for (int f = 0; f < n.face_count(); ++f)
    for (int k = 0; k < n.size_of(f); ++k)
      if (n.corner(f, k) == v) {
        star.wedges.push_back({f, k});
        add_spoke(n.next(f, k), n.sharpness_after(f, k));
        add_spoke(n.prev(f, k), n.sharpness_before(f, k));
      }
  return star;
}

CageNeighbourhoods::CageNeighbourhoods(const Cage& cage)
    : cage_(cage),
      vertex_sharpness_(cage.vertices.size(), 0),
      edge_sharpness_(cage.face_corners.size(), 0),
      incident_offsets_(cage.vertices.size() + 1, 0),
      has_surface_(cage.face_count(), true) {
  std::map<EdgeKey, double> creases;
  for (const model::Crease& c : cage.creases)
    creases[edge_key(c.vertices[0], c.vertices[1])] = effective(c.sharpness);
  std::map<EdgeKey, int> uses;
  const auto each_edge = [&](auto&& visit) {
    for (Index f = 0; f < cage.face_count(); ++f) {
      const auto face = cage.face(f);
      for (std::size_t k = 0; k < face.size(); ++k)
        visit(f, cage.face_offsets[f] + k, face[k], face[(k + 1) % face.size()]);
    }
  };
  each_edge([&](Index, std::size_t, Index a, Index b) { ++uses[edge_key(a, b)]; });
  std::vector<bool> on_boundary(cage.vertices.size(), false);
  std::vector<bool> beside_smooth_boundary(cage.vertices.size(), false);
  each_edge([&](Index, std::size_t at, Index a, Index b) {
    const bool boundary = uses[edge_key(a, b)] == 1;
    const auto crease = creases.find(edge_key(a, b));
    const double sharpness = crease == creases.end() ? 0 : crease->second;
    edge_sharpness_[at] = boundary ? kInfinite : sharpness;
    if (!boundary) return;
    on_boundary[a] = on_boundary[b] = true;
    if (sharpness < kInfinite) beside_smooth_boundary[a] = beside_smooth_boundary[b] = true;
  });
  for (const Index v : cage.face_corners) ++incident_offsets_[v + 1];
  for (std::size_t v = 0; v < cage.vertices.size(); ++v)
    incident_offsets_[v + 1] += incident_offsets_[v];
  incident_.resize(cage.face_corners.size());
  std::vector<Index> fill(incident_offsets_.begin(), incident_offsets_.end() - 1);
  for (Index f = 0; f < cage.face_count(); ++f)
    for (const Index v : cage.face(f)) incident_[fill[v]++] = f;
  for (const model::Corner& c : cage.corners) vertex_sharpness_[c.vertex] = effective(c.sharpness);
  if (cage.boundary == model::BoundaryRule::edge_and_corner)
    for (std::size_t v = 0; v < cage.vertices.size(); ++v)
      if (on_boundary[v] && faces_at(static_cast<Index>(v)).size() == 1)
        vertex_sharpness_[v] = kInfinite;
  for (const Index f : cage.holes) has_surface_[f] = false;
  if (cage.boundary != model::BoundaryRule::none) return;
  for (Index f = 0; f < cage.face_count(); ++f)
    for (const Index v : cage.face(f))
      if (beside_smooth_boundary[v]) has_surface_[f] = false;
}

std::span<const Index> CageNeighbourhoods::faces_at(Index v) const {
  return std::span(incident_).subspan(incident_offsets_[v],
                                      incident_offsets_[v + 1] - incident_offsets_[v]);
}

Neighbourhood CageNeighbourhoods::of(Index face) const {
  std::vector<Index> faces;
  for (const Index v : cage_.face(face))
    for (const Index f : faces_at(v)) faces.push_back(f);
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  std::erase(faces, face);
  faces.insert(faces.begin(), face);

  Neighbourhood n;
  std::map<Index, Index> local;
  for (const Index f : faces) {
    const auto corners = cage_.face(f);
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const auto [at, fresh] = local.try_emplace(corners[k], static_cast<Index>(n.points.size()));
      if (fresh) {
        n.points.push_back(cage_.vertices[corners[k]]);
        n.vertex_sharpness.push_back(vertex_sharpness_[corners[k]]);
      }
      n.corners.push_back(at->second);
      n.edge_sharpness.push_back(edge_sharpness_[cage_.face_offsets[f] + k]);
    }
    n.offsets.push_back(static_cast<Index>(n.corners.size()));
  }
  return n;
}

}  // namespace limitgauge::verifier
