#include "verifier/vertex_limit.h"

#include <algorithm>
#include <numbers>

namespace limitgauge::verifier {
namespace {

using model::Index;
using model::Vec3;
using std::numbers::pi;

/// The faces around a vertex from one side of a sector to the other, counter-clockwise: edge[i] and
/// edge[i + 1] bound the face whose opposite corner is face[i]. A full turn has as many edges as
/// faces, an open sector one edge more.
struct Sector {
  std::vector<Vec3> edge, face;
  bool full_turn = false;
};

Sector sector_of(const Neighbourhood& n, const Star& star, int face, int corner) {
  const auto wedge_with = [&](auto&& fits) -> std::optional<Star::Wedge> {
    const auto at = std::find_if(star.wedges.begin(), star.wedges.end(), fits);
    return at == star.wedges.end() ? std::nullopt : std::optional(*at);
  };
  Star::Wedge first{face, corner};
  while (n.sharpness_after(first.face, first.corner) <= 0) {
    const Index edge = n.next(first.face, first.corner);
    const auto before =
        wedge_with([&](const Star::Wedge& w) { return n.prev(w.face, w.corner) == edge; });
    if (!before || before->face == face) break;
    first = *before;
  }
  Sector s;
  s.full_turn = n.sharpness_after(first.face, first.corner) <= 0;
  for (std::optional<Star::Wedge> w = first; w;) {
    s.edge.push_back(n.points[n.next(w->face, w->corner)]);
    s.face.push_back(n.points[n.corner(w->face, (w->corner + 2) % 4)]);
    const Index edge = n.prev(w->face, w->corner);
    const bool end = n.sharpness_before(w->face, w->corner) > 0;
    if (end) s.edge.push_back(n.points[edge]);
    const auto after =
        end ? std::nullopt
            : wedge_with([&](const Star::Wedge& c) { return n.next(c.face, c.corner) == edge; });
    w = after && after->face != first.face ? after : std::nullopt;
  }
  return s;
}

VertexLimit smooth_limit(const Vec3& v, const Sector& s) {
  const double n = static_cast<double>(s.face.size());
  Vec3 edges, faces;
  for (const Vec3& e : s.edge) edges += e;
  for (const Vec3& f : s.face) faces += f;
  VertexLimit limit{(v * (n * n) + edges * 4 + faces) / (n * (n + 5)), std::nullopt};
  if (n < 3) return limit;
  const double step = 2 * pi / n, c = std::cos(step);
  const double a = 1 + c + std::cos(pi / n) * std::sqrt(2 * (9 + c));
  VertexLimit::Tangents t;
  for (std::size_t i = 0; i < s.face.size(); ++i) {
    const double here = step * static_cast<double>(i), ahead = here + step;
    t.first += s.edge[i] * (a * std::cos(here)) + s.face[i] * (std::cos(here) + std::cos(ahead));
    t.second += s.edge[i] * (a * std::sin(here)) + s.face[i] * (std::sin(here) + std::sin(ahead));
  }
  limit.tangents = t;
  return limit;
}

/// The derivative across a crease of a sector with three faces or two: the left eigenvector of the
/// refinement matrix that is sin(iθ), θ = π/faces, on the inner edges. Its weights on the vertex
/// and on the two crease edges follow from the columns of the matrix; λ is its eigenvalue. (The
/// masks of Biermann, Levin and Zorin 2000 belong to their modified rules, which coincide for two
/// faces only.)
Vec3 across_crease(const Vec3& v, const Sector& s) {
  const std::size_t faces = s.face.size();
  const double theta = pi / static_cast<double>(faces), c = std::cos(theta);
  const double mean = 0.625 + c / 8, lambda = (mean + std::sqrt(mean * mean - 0.25)) / 2;
  const auto wave = [&](std::size_t i) { return std::sin(theta * static_cast<double>(i)); };
  const auto face_weight = [&](std::size_t i) {
    return (wave(i) + wave(i + 1)) / (16 * (lambda - 0.25));
  };
  Vec3 sum;
  double into_vertex = 0;
  for (std::size_t i = 0; i < faces; ++i) {
    if (i > 0) sum += s.edge[i] * wave(i), into_vertex += 0.375 * wave(i);
    sum += s.face[i] * face_weight(i);
    into_vertex += face_weight(i) / 4;
  }
  // (λ − 1/2)·e − v/8 = into_edge and (λ − 3/4)·v − e = into_vertex, for the weights e and v.
  const double into_edge = wave(1) / 16 + face_weight(0) / 4;
  const double determinant = (lambda - 0.5) * (lambda - 0.75) - 0.125;
  const double edge_weight = (into_edge * (lambda - 0.75) + into_vertex / 8) / determinant;
  const double vertex_weight = ((lambda - 0.5) * into_vertex + into_edge) / determinant;
  return sum + (s.edge.front() + s.edge.back()) * edge_weight + v * vertex_weight;
}

/// No tangents for more than three faces: there the plain rules are not tangent continuous across
/// the sector, and what a face sees is read off the surface.
VertexLimit crease_limit(const Vec3& v, const Vec3& end0, const Vec3& end1, const Sector& s) {
  VertexLimit limit{(v * 4 + end0 + end1) / 6, std::nullopt};
  const Vec3 along = s.edge.front() - s.edge.back();
  if (s.face.size() == 1)
    limit.tangents = {along, s.edge.front() + s.edge.back() - v * 2};
  else if (s.face.size() <= 3)
    limit.tangents = {along, across_crease(v, s)};
  return limit;
}

}  // namespace

VertexLimit vertex_limit(const Neighbourhood& n, int k) {
  const Index v = n.corner(0, k);
  const Star star = star_of(n, v);
  std::vector<Vec3> sharp_ends;
  for (const Star::Spoke& s : star.spokes)
    if (s.sharpness > 0) sharp_ends.push_back(n.points[s.end]);
  const Sector sector = sector_of(n, star, 0, k);
  if (n.vertex_sharpness[v] > 0 || sharp_ends.size() > 2) {
    VertexLimit limit{n.points[v], std::nullopt};
    if (sector.face.size() == 1)
      limit.tangents = {sector.edge.front() - n.points[v], sector.edge.back() - n.points[v]};
    return limit;
  }
  if (sharp_ends.size() == 2)
    return crease_limit(n.points[v], sharp_ends[0], sharp_ends[1], sector);
  if (sharp_ends.size() == 1) return {n.points[v], std::nullopt};
  return smooth_limit(n.points[v], sector);
}

}  // namespace limitgauge::verifier
