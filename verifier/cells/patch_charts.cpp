#include "verifier/cells/patch_charts.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "verifier/tolerance.h"

namespace limitgauge::verifier {
namespace {

using model::Vec3;

/// A cubic is determined by four values, so two that agree at five are one.
constexpr double kProbes[] = {0, 0.25, 0.5, 0.75, 1};

struct Turned {
  double u = 0, v = 0;
};
Turned turn(double u, double v, int turns) {
  switch (turns & 3) {
    case 0:
      return {u, v};
    case 1:
      return {-v, u};
    case 2:
      return {-u, -v};
    default:
      return {v, -u};
  }
}
Turned corner(int k) {
  constexpr Turned kCorners[] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  return kCorners[k & 3];
}
/// Edge k runs from corner k to corner k + 1.
Turned on_edge(int k, double t) {
  const Turned a = corner(k), b = corner(k + 1);
  return {a.u + (b.u - a.u) * t, a.v + (b.v - a.v) * t};
}

struct Place {
  Vec3 position, du, dv;
  double size = 1;  ///< of the cell: derivatives are good to rounding over it
};

class Matcher {
 public:
  Matcher(const std::vector<SurfaceCell>& cells, const ParameterIndex& index)
      : cells_(cells), index_(index) {
    model::Box3 box;
    for (const SurfaceCell& cell : cells) box.add(control_box(cell.shape));
    tolerance_ = cells.empty() ? 0 : kSameEdge * (1 + length(box.size()));
  }

  double tolerance() const { return tolerance_; }

  std::optional<Place> at(int patch, const Turned& p) const {
    const auto k = index_.find(patch, p.u, p.v);
    if (!k) return std::nullopt;
    const SurfaceCell& c = cells_[*k];
    const BezierJet j = jet(c.shape, (p.u - c.u) / c.size_u, (p.v - c.v) / c.size_v);
    return Place{j.position, j.du / c.size_u, j.dv / c.size_v, std::min(c.size_u, c.size_v)};
  }

  /// Patch b's edge j continues patch a across its edge i, the frames differing by `turns`.
  bool smooth(int a, int i, int b, int j, int turns) const {
    return agree_on_cells_of(a, i, b, j, turns) && agree_on_cells_of(b, j, a, i, (4 - turns) & 3);
  }

 private:
  /// Compares at the cells of a along its edge i; b's edge runs the other way.
  bool agree_on_cells_of(int a, int i, int b, int j, int turns) const {
    bool same = true;
    const Turned p = corner(i), q = corner(i + 1);
    const ParameterRect edge{std::min(p.u, q.u), std::max(p.u, q.u), std::min(p.v, q.v),
                             std::max(p.v, q.v)};
    index_.overlapping(a, edge, [&](std::uint32_t k) {
      const ParameterRect r = rect_of(cells_[k]);
      const double low = i % 2 == 0 ? r.u0 : r.v0, high = i % 2 == 0 ? r.u1 : r.v1;
      const double side =
          i % 2 == 0 ? (edge.v0 - r.v0) * (edge.v0 - r.v1) : (edge.u0 - r.u0) * (edge.u0 - r.u1);
      if (side != 0) return;
      for (const double x : kProbes) {
        const double along = low + (high - low) * x, t = i < 2 ? along : 1 - along;
        same = same && agree(a, on_edge(i, t), b, on_edge(j, 1 - t), turns);
      }
    });
    return same;
  }

  bool agree(int a, const Turned& pa, int b, const Turned& pb, int turns) const {
    const auto x = at(a, pa), y = at(b, pb);
    if (!x || !y) return true;  // beside an irregular vertex: a point of no size
    const Turned u = turn(1, 0, turns), v = turn(0, 1, turns);
    // x_a = R·x_b: the derivative by a's parameter i is the sum over j of R_ij times b's.
    const Vec3 du = y->du * u.u + y->dv * v.u, dv = y->du * u.v + y->dv * v.v;
    const double size = std::min(x->size, y->size);
    return distance(x->position, y->position) <= tolerance_ &&
           distance(x->du, du) * size <= tolerance_ && distance(x->dv, dv) * size <= tolerance_;
  }

  const std::vector<SurfaceCell>& cells_;
  const ParameterIndex& index_;
  double tolerance_ = 0;
};

struct Edge {
  Vec3 middle;
  int patch = 0, edge = 0;
};

std::vector<Edge> edges_by_x(const Matcher& matcher, int patches) {
  std::vector<Edge> edges;
  for (int patch = 0; patch < patches; ++patch)
    for (int k = 0; k < 4; ++k)
      if (const auto place = matcher.at(patch, on_edge(k, 0.5)))
        edges.push_back({place->position, patch, k});
  std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) {
    if (a.middle.x != b.middle.x) return a.middle.x < b.middle.x;
    return a.patch != b.patch ? a.patch < b.patch : a.edge < b.edge;
  });
  return edges;
}

using Neighbours = std::vector<std::array<std::optional<PlacedPatch>, 4>>;

/// b's square beside a's, b's edge j lying on a's edge i.
PlacedPatch placed(int i, int b, int j) {
  const int turns = (i + 2 - j) & 3;
  constexpr Turned kBeside[] = {{0, -1}, {1, 0}, {0, 1}, {-1, 0}};
  return {b, turns, kBeside[i].u, kBeside[i].v};
}

Neighbours find_neighbours(const Matcher& matcher, int patches) {
  Neighbours out(patches);
  const std::vector<Edge> edges = edges_by_x(matcher, patches);
  const double near = matcher.tolerance();
  for (std::size_t n = 0; n < edges.size(); ++n) {
    std::vector<std::size_t> same;
    for (std::size_t m = n + 1; m < edges.size() && edges[m].middle.x - edges[n].middle.x <= near;
         ++m)
      if (distance(edges[m].middle, edges[n].middle) <= near) same.push_back(m);
    for (const std::size_t m : same) {
      const Edge &a = edges[n], &b = edges[m];
      auto &to_b = out[a.patch][a.edge], &to_a = out[b.patch][b.edge];
      const PlacedPatch p = placed(a.edge, b.patch, b.edge);
      if (to_b || to_a || !matcher.smooth(a.patch, a.edge, b.patch, b.edge, p.turns)) continue;
      to_b = p;
      to_a = placed(b.edge, a.patch, a.edge);
    }
  }
  return out;
}

/// The neighbour across edge `edge` of the chart, seen from `from`.
std::optional<PlacedPatch> step(const Neighbours& all, const PlacedPatch& from, int edge) {
  const auto& next = all[from.patch][(edge - from.turns) & 3];
  if (!next) return std::nullopt;
  const Turned move = turn(next->at_u, next->at_v, from.turns);
  return PlacedPatch{next->patch, (next->turns + from.turns) & 3, from.at_u + move.u,
                     from.at_v + move.v};
}

bool equal(const PlacedPatch& a, const PlacedPatch& b) {
  return a.patch == b.patch && a.turns == b.turns && a.at_u == b.at_u && a.at_v == b.at_v;
}

std::vector<PlacedPatch> chart_of(const Neighbours& all, int patch) {
  const PlacedPatch self{patch, 0, 0, 0};
  std::vector<PlacedPatch> chart{self};
  for (int k = 0; k < 4; ++k)
    if (const auto side = step(all, self, k)) chart.push_back(*side);
  for (int k = 0; k < 4; ++k) {
    const auto one = step(all, self, k), other = step(all, self, (k + 1) & 3);
    if (!one || !other) continue;
    const auto there = step(all, *one, (k + 1) & 3), again = step(all, *other, k);
    if (there && again && equal(*there, *again)) chart.push_back(*there);
  }
  return chart;
}

/// Rotation of a rectangle about the middle of its own unit square.
ParameterRect turned_rect(const ParameterRect& r, int turns) {
  const Turned a = turn(r.u0 - 0.5, r.v0 - 0.5, turns), b = turn(r.u1 - 0.5, r.v1 - 0.5, turns);
  return {std::min(a.u, b.u) + 0.5, std::max(a.u, b.u) + 0.5, std::min(a.v, b.v) + 0.5,
          std::max(a.v, b.v) + 0.5};
}

}  // namespace

ParameterRect PlacedPatch::to_own(const ParameterRect& c) const {
  return turned_rect({c.u0 - at_u, c.u1 - at_u, c.v0 - at_v, c.v1 - at_v}, 4 - turns);
}
ParameterRect PlacedPatch::to_chart(const ParameterRect& own) const {
  const ParameterRect r = turned_rect(own, turns);
  return {r.u0 + at_u, r.u1 + at_u, r.v0 + at_v, r.v1 + at_v};
}

PatchCharts::PatchCharts(const std::vector<SurfaceCell>& cells, const ParameterIndex& index) {
  const Matcher matcher(cells, index);
  const Neighbours all = find_neighbours(matcher, index.patch_count());
  for (int patch = 0; patch < index.patch_count(); ++patch) charts_.push_back(chart_of(all, patch));
}

bool PatchCharts::covers(int patch, int i, int j) const {
  return std::any_of(charts_[patch].begin(), charts_[patch].end(),
                     [&](const PlacedPatch& p) { return p.at_u == i && p.at_v == j; });
}

}  // namespace limitgauge::verifier
