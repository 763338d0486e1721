#include <algorithm>
#include <array>

#include "verifier/surface/refinement.h"

namespace limitgauge::verifier {

using model::Index;
using model::Vec3;

namespace {

/// Uniform creasing: one level of sharpness is used up by each refinement.
double child_sharpness(double s) {
  return s > 1 ? s - 1 : 0;
}
double this_level(double s) {
  return s;
}

std::vector<Index> sharp_ends(const Star& star, double (*level)(double)) {
  std::vector<Index> ends;
  for (const Star::Spoke& s : star.spokes)
    if (level(s.sharpness) > 0) ends.push_back(s.end);
  return ends;
}

/// How much of the sharper rule still counts while sharpness runs out: the mean of the sharpnesses
/// that end in this step, at most one (OpenSubdiv, Sdc::Crease::ComputeFractionalWeightAtVertex).
double fraction_left(double vertex_sharpness, const Star& star) {
  double sum = 0;
  int count = 0;
  const auto add = [&](double s) {
    if (s > 0 && child_sharpness(s) <= 0) sum += s, ++count;
  };
  add(vertex_sharpness);
  for (const Star::Spoke& spoke : star.spokes) add(spoke.sharpness);
  return count == 0 ? 0 : std::min(1.0, sum / count);
}

Neighbourhood without_points(const Neighbourhood& n) {
  return {{}, n.vertex_sharpness, n.corners, n.edge_sharpness, n.offsets};
}

}  // namespace

Refinement::Refinement(const Neighbourhood& n) : n_(without_points(n)) {
  for (int k = 0; k < n_.size_of(0); ++k) centre_.push_back(n_.corner(0, k));
  collect_edges();
  for (const Index v : centre_) vertices_.push_back(vertex_of(v));
}

bool Refinement::is_centre(Index v) const {
  return std::find(centre_.begin(), centre_.end(), v) != centre_.end();
}
int Refinement::centre_of(Index v) const {
  return static_cast<int>(std::find(centre_.begin(), centre_.end(), v) - centre_.begin());
}

int Refinement::find_edge(Index a, Index b) const {
  const auto at = std::find_if(edges_.begin(), edges_.end(), [&](const Edge& e) {
    return (e.a == a && e.b == b) || (e.a == b && e.b == a);
  });
  return static_cast<int>(at - edges_.begin());
}

void Refinement::collect_edges() {
  for (int f = 0; f < n_.face_count(); ++f)
    for (int k = 0; k < n_.size_of(f); ++k) {
      const Index a = n_.corner(f, k), b = n_.next(f, k);
      if (!is_centre(a) && !is_centre(b)) continue;
      const auto at = static_cast<std::size_t>(find_edge(a, b));
      if (at == edges_.size()) edges_.push_back({a, b, n_.sharpness_after(f, k), {}});
      edges_[at].faces.push_back(f);
    }
}

Refinement::Vertex Refinement::vertex_of(Index v) const {
  const Star star = star_of(n_, v);
  const double s = n_.vertex_sharpness[v];
  Vertex out;
  out.at = v;
  for (const Star::Spoke& spoke : star.spokes) out.ends.push_back(spoke.end);
  for (const Star::Wedge& wedge : star.wedges) out.faces.push_back(wedge.face);
  out.sharp_now = sharp_ends(star, this_level);
  out.sharp_then = sharp_ends(star, child_sharpness);
  const auto rule_for = [](double sharpness, std::size_t sharp) {
    if (sharpness > 0 || sharp > 2) return Rule::corner;
    return sharp == 2 ? Rule::crease : Rule::smooth;
  };
  out.now = rule_for(s, out.sharp_now.size());
  out.then = rule_for(child_sharpness(s), out.sharp_then.size());
  out.left = fraction_left(s, star);
  return out;
}

Vec3 Refinement::edge_point(const Edge& e, std::span<const Vec3> before,
                            const Vec3* face_points) const {
  const Vec3 ends = before[e.a] + before[e.b];
  const Vec3 crease = ends * 0.5;
  if (e.sharpness >= 1 || e.faces.size() < 2) return crease;
  Vec3 face_sum;
  for (const int f : e.faces) face_sum += face_points[f];
  const Vec3 smooth = (ends + face_sum) * 0.25;
  return e.sharpness > 0 ? lerp(smooth, crease, e.sharpness) : smooth;
}

Vec3 Refinement::by_rule(Rule rule, const Vertex& v, std::span<const Index> sharp,
                         std::span<const Vec3> before, const Vec3* face_points) {
  const Vec3& p = before[v.at];
  Vec3 sum;
  if (rule == Rule::corner) return p;
  if (rule == Rule::crease) {
    for (const Index end : sharp) sum += before[end];
    return p * 0.75 + sum * 0.125;
  }
  for (const Index end : v.ends) sum += before[end];
  for (const int f : v.faces) sum += face_points[f];
  const double valence = static_cast<double>(v.ends.size());
  return p * ((valence - 2) / valence) + sum / (valence * valence);
}

Vec3 Refinement::vertex_point(const Vertex& v, std::span<const Vec3> before,
                              const Vec3* face_points) {
  const Vec3 sharper = by_rule(v.now, v, v.sharp_now, before, face_points);
  if (v.now == v.then) return sharper;
  return lerp(by_rule(v.then, v, v.sharp_then, before, face_points), sharper, v.left);
}

std::vector<Vec3> Refinement::points(std::span<const Vec3> before) const {
  const std::size_t edges = vertices_.size(), faces = edges + edges_.size();
  std::vector<Vec3> after(faces + static_cast<std::size_t>(n_.face_count()));
  Vec3* const face_points = after.data() + faces;
  for (int f = 0; f < n_.face_count(); ++f) {
    Vec3 sum;
    for (int k = 0; k < n_.size_of(f); ++k) sum += before[n_.corner(f, k)];
    face_points[f] = sum / n_.size_of(f);
  }
  for (std::size_t e = 0; e < edges_.size(); ++e)
    after[edges + e] = edge_point(edges_[e], before, face_points);
  for (std::size_t v = 0; v < vertices_.size(); ++v)
    after[v] = vertex_point(vertices_[v], before, face_points);
  return after;
}

/// Whether the child of face f at its corner j touches the child of face 0 at its corner k.
bool Refinement::touches(int f, int j, int k) const {
  const Index c = n_.corner(0, k), at = n_.corner(f, j);
  if (f == 0 || at == c) return true;
  if (at != n_.next(0, k) && at != n_.prev(0, k)) return false;
  return n_.next(f, j) == c || n_.prev(f, j) == c;
}

/// Gathers the faces of a child's neighbourhood, numbering points as they are met.
Refinement::Child Refinement::child(int k) const {
  Child out;
  const auto edge_base = static_cast<Index>(centre_.size());
  const auto face_base = edge_base + static_cast<Index>(edges_.size());
  std::vector<Index> local(static_cast<std::size_t>(face_base + n_.face_count()), Index{-1});
  const auto use = [&](Index id, double sharpness) {
    if (local[id] < 0) {
      local[id] = static_cast<Index>(out.from.size());
      out.from.push_back(id);
      out.net.vertex_sharpness.push_back(sharpness);
    }
    return local[id];
  };
  const auto add = [&](int f, int j, int rotation) {
    const Index v = n_.corner(f, j);
    const int here = centre_of(v), ahead = find_edge(v, n_.next(f, j)),
              behind = find_edge(v, n_.prev(f, j));
    const double s_ahead = child_sharpness(edges_[ahead].sharpness),
                 s_behind = child_sharpness(edges_[behind].sharpness);
    const std::array<Index, 4> ids = {use(here, child_sharpness(n_.vertex_sharpness[v])),
                                      use(edge_base + ahead, 0), use(face_base + f, 0),
                                      use(edge_base + behind, 0)};
    const std::array<double, 4> sharp = {s_ahead, 0, 0, s_behind};
    for (int m = 0; m < 4; ++m) {
      out.net.corners.push_back(ids[(m + 4 - rotation) % 4]);
      out.net.edge_sharpness.push_back(sharp[(m + 4 - rotation) % 4]);
    }
    out.net.offsets.push_back(static_cast<Index>(out.net.corners.size()));
  };
  add(0, k, n_.size_of(0) == 4 ? k : 0);
  for (int f = 0; f < n_.face_count(); ++f)
    for (int j = 0; j < n_.size_of(f); ++j)
      if (!(f == 0 && j == k) && is_centre(n_.corner(f, j)) && touches(f, j, k)) add(f, j, 0);
  return out;
}

std::vector<Neighbourhood> refine(const Neighbourhood& n) {
  const Refinement step(n);
  const std::vector<Vec3> points = step.points(n.points);
  std::vector<Neighbourhood> children;
  for (int k = 0; k < n.size_of(0); ++k) {
    Refinement::Child child = step.child(k);
    for (const Index from : child.from) child.net.points.push_back(points[from]);
    children.push_back(std::move(child.net));
  }
  return children;
}

}  // namespace limitgauge::verifier
