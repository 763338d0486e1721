#include <algorithm>
#include <array>

#include "verifier/surface/neighbourhood.h"

namespace limitgauge::verifier {
namespace {

using model::Index;
using model::Vec3;

/// Uniform creasing: one level of sharpness is used up by each refinement.
double child_sharpness(double s) {
  return s > 1 ? s - 1 : 0;
}

enum class Rule { smooth, crease, corner };  // a dart is smooth

Rule rule_for(double vertex_sharpness, const Star& star, double (*level)(double)) {
  if (level(vertex_sharpness) > 0) return Rule::corner;
  const auto sharp = std::count_if(star.spokes.begin(), star.spokes.end(),
                                   [&](const Star::Spoke& s) { return level(s.sharpness) > 0; });
  return sharp > 2 ? Rule::corner : sharp == 2 ? Rule::crease : Rule::smooth;
}
double this_level(double s) {
  return s;
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

/// One refinement step of a neighbourhood: points of the next level, by kind.
class Step {
 public:
  explicit Step(const Neighbourhood& n) : n_(n) {
    for (int f = 0; f < n.face_count(); ++f) face_points_.push_back(centroid(f));
    for (int k = 0; k < n.size_of(0); ++k) centre_.push_back(n.corner(0, k));
    collect_edges();
    for (Edge& e : edges_) e.point = edge_point(e);
    for (const Index v : centre_) vertex_points_.push_back(vertex_point(v));
  }

  Neighbourhood child(int k) const;

 private:
  struct Edge {
    Index a = 0, b = 0;
    double sharpness = 0;
    int faces = 0;
    Vec3 face_sum, point;
  };

  Vec3 centroid(int f) const {
    Vec3 sum;
    for (int k = 0; k < n_.size_of(f); ++k) sum += n_.points[n_.corner(f, k)];
    return sum / n_.size_of(f);
  }

  bool is_centre(Index v) const {
    return std::find(centre_.begin(), centre_.end(), v) != centre_.end();
  }
  int centre_of(Index v) const {
    return static_cast<int>(std::find(centre_.begin(), centre_.end(), v) - centre_.begin());
  }

  int find_edge(Index a, Index b) const {
    const auto at = std::find_if(edges_.begin(), edges_.end(), [&](const Edge& e) {
      return (e.a == a && e.b == b) || (e.a == b && e.b == a);
    });
    return static_cast<int>(at - edges_.begin());
  }

  void collect_edges() {
    for (int f = 0; f < n_.face_count(); ++f)
      for (int k = 0; k < n_.size_of(f); ++k) {
        const Index a = n_.corner(f, k), b = n_.next(f, k);
        if (!is_centre(a) && !is_centre(b)) continue;
        const auto at = static_cast<std::size_t>(find_edge(a, b));
        if (at == edges_.size()) edges_.push_back({a, b, n_.sharpness_after(f, k), 0, {}, {}});
        ++edges_[at].faces;
        edges_[at].face_sum += face_points_[f];
      }
  }

  Vec3 edge_point(const Edge& e) const {
    const Vec3 ends = n_.points[e.a] + n_.points[e.b];
    const Vec3 crease = ends * 0.5;
    if (e.sharpness >= 1 || e.faces < 2) return crease;
    const Vec3 smooth = (ends + e.face_sum) * 0.25;
    return e.sharpness > 0 ? lerp(smooth, crease, e.sharpness) : smooth;
  }

  Vec3 by_rule(Rule rule, Index v, const Star& star, double (*level)(double)) const {
    const Vec3& p = n_.points[v];
    Vec3 sum;
    if (rule == Rule::corner) return p;
    if (rule == Rule::crease) {
      for (const Star::Spoke& s : star.spokes)
        if (level(s.sharpness) > 0) sum += n_.points[s.end];
      return p * 0.75 + sum * 0.125;
    }
    for (const Star::Spoke& s : star.spokes) sum += n_.points[s.end];
    for (const Star::Wedge& w : star.wedges) sum += face_points_[w.face];
    const double valence = static_cast<double>(star.spokes.size());
    return p * ((valence - 2) / valence) + sum / (valence * valence);
  }

  Vec3 vertex_point(Index v) const {
    const Star star = star_of(n_, v);
    const double s = n_.vertex_sharpness[v];
    const Rule now = rule_for(s, star, this_level), then = rule_for(s, star, child_sharpness);
    const Vec3 sharper = by_rule(now, v, star, this_level);
    if (now == then) return sharper;
    return lerp(by_rule(then, v, star, child_sharpness), sharper, fraction_left(s, star));
  }

  /// Whether the child of face f at its corner j touches the child of face 0 at its corner k.
  bool touches(int f, int j, int k) const {
    const Index c = n_.corner(0, k), at = n_.corner(f, j);
    if (f == 0 || at == c) return true;
    if (at != n_.next(0, k) && at != n_.prev(0, k)) return false;
    return n_.next(f, j) == c || n_.prev(f, j) == c;
  }

  const Neighbourhood& n_;
  std::vector<Vec3> face_points_, vertex_points_;
  std::vector<Index> centre_;
  std::vector<Edge> edges_;
};

/// Gathers the faces of a child's neighbourhood, numbering points as they are met.
Neighbourhood Step::child(int k) const {
  Neighbourhood out;
  const std::size_t edge_base = centre_.size(), face_base = edge_base + edges_.size();
  std::vector<Index> local(face_base + face_points_.size(), Index{-1});
  const auto use = [&](std::size_t id, const Vec3& p, double sharpness) {
    if (local[id] < 0) {
      local[id] = static_cast<Index>(out.points.size());
      out.points.push_back(p);
      out.vertex_sharpness.push_back(sharpness);
    }
    return local[id];
  };
  const auto add = [&](int f, int j, int rotation) {
    const Index v = n_.corner(f, j);
    const int here = centre_of(v), ahead = find_edge(v, n_.next(f, j)),
              behind = find_edge(v, n_.prev(f, j));
    const double s_ahead = child_sharpness(edges_[ahead].sharpness),
                 s_behind = child_sharpness(edges_[behind].sharpness);
    const std::array<Index, 4> ids = {
        use(here, vertex_points_[here], child_sharpness(n_.vertex_sharpness[v])),
        use(edge_base + ahead, edges_[ahead].point, 0), use(face_base + f, face_points_[f], 0),
        use(edge_base + behind, edges_[behind].point, 0)};
    const std::array<double, 4> sharp = {s_ahead, 0, 0, s_behind};
    for (int m = 0; m < 4; ++m) {
      out.corners.push_back(ids[(m + 4 - rotation) % 4]);
      out.edge_sharpness.push_back(sharp[(m + 4 - rotation) % 4]);
    }
    out.offsets.push_back(static_cast<Index>(out.corners.size()));
  };
  add(0, k, n_.size_of(0) == 4 ? k : 0);
  for (int f = 0; f < n_.face_count(); ++f)
    for (int j = 0; j < n_.size_of(f); ++j)
      if (!(f == 0 && j == k) && is_centre(n_.corner(f, j)) && touches(f, j, k)) add(f, j, 0);
  return out;
}

}  // namespace

std::vector<Neighbourhood> refine(const Neighbourhood& n) {
  const Step step(n);
  std::vector<Neighbourhood> children;
  for (int k = 0; k < n.size_of(0); ++k) children.push_back(step.child(k));
  return children;
}

}  // namespace limitgauge::verifier
