#include "engine/surface/section/triangle_march.h"

#include <array>
#include <cstddef>

namespace limitgauge::engine::surface {
namespace {

using Edge = GridEntry::Edge;

/// What leaving through an edge leads to: a neighbouring cell and the edge of the triangle there.
struct Passage {
  int du = 0, dv = 0;
  Edge into = Edge::ab;
};

constexpr std::array<Passage, 6> kPassages = {{
    {0, -1, Edge::cd},  // out through ab
    {1, 0, Edge::da},   // bc
    {0, 0, Edge::ac},   // ca
    {0, 0, Edge::ca},   // ac
    {0, 1, Edge::ab},   // cd
    {-1, 0, Edge::bc},  // da
}};

/// The edge that follows or precedes an edge in its triangle.
constexpr std::array<Edge, 6> kNext = {Edge::bc, Edge::ca, Edge::ab, Edge::cd, Edge::da, Edge::ac};
constexpr std::array<Edge, 6> kPrevious = {Edge::ca, Edge::ab, Edge::bc,
                                           Edge::da, Edge::ac, Edge::cd};

constexpr std::size_t number(Edge edge) {
  return static_cast<std::size_t>(edge);
}

/// Offsets of the points of an edge and of the point opposite to it from point a.
struct Corners {
  int from = 0, to = 0, opposite = 0;
};
std::array<Corners, 6> corners_of_edges(int columns) {
  const int a = 0, b = 1, c = columns + 1, d = columns;
  return {{{a, b, c}, {b, c, a}, {c, a, b}, {a, c, d}, {c, d, a}, {d, a, c}}};
}

}  // namespace

double Vec3::*coordinate_of(int axis) {
  return axis == 0 ? &Vec3::x : axis == 1 ? &Vec3::y : &Vec3::z;
}

SectionEnd side_of(const GridEntry& entry) {
  switch (entry.edge) {
    case Edge::ab:
      return {0, entry.u};
    case Edge::bc:
      return {1, entry.v};
    case Edge::cd:
      return {2, entry.u};
    default:
      return {3, entry.v};
  }
}

int triangle_of(const GridEntry& entry, int columns) {
  return 2 * (entry.v * (columns - 1) + entry.u) + (entry.edge >= Edge::ac ? 1 : 0);
}

TriangleMarch::TriangleMarch(const Grid& grid, const AxisPlane& plane)
    : grid_(grid), plane_(plane), coordinate_(coordinate_of(plane.axis)) {}

/// From below to above whichever triangle asks, so that neighbours get the same point bit by bit.
void TriangleMarch::add_crossing(const Vec3& below, const Vec3& above,
                                 std::vector<Vec3>& points) const {
  const double low = below.*coordinate_;
  const double t = (plane_.value - low) / (above.*coordinate_ - low);
  Vec3& p =
      points.emplace_back(Vec3{below.x + (above.x - below.x) * t, below.y + (above.y - below.y) * t,
                               below.z + (above.z - below.z) * t});
  p.*coordinate_ = plane_.value;
}

void TriangleMarch::follow(const GridEntry& start, SectionChain& chain,
                           SectionScratch* visited) const {
  const auto corners = corners_of_edges(grid_.columns);
  const unsigned columns = static_cast<unsigned>(grid_.columns - 1);
  const unsigned rows = static_cast<unsigned>(grid_.rows - 1);
  const Vec3* points = grid_.points.data();
  GridEntry at = start;
  const int a = at.v * grid_.columns + at.u;
  int above = a + corners[number(at.edge)].from, below = a + corners[number(at.edge)].to;
  for (;;) {
    add_crossing(points[below], points[above], chain.points);
    if (visited) {
      visited->triangles.push_back(triangle_of(at, grid_.columns));
      visited->visited[visited->triangles.back()] = 1;
    }
    const int opposite = at.v * grid_.columns + at.u + corners[number(at.edge)].opposite;
    const bool high = points[opposite].*coordinate_ >= plane_.value;
    (high ? above : below) = opposite;
    const GridEntry out{at.u, at.v, high ? kNext[number(at.edge)] : kPrevious[number(at.edge)]};
    const Passage& passage = kPassages[number(out.edge)];
    at = {at.u + passage.du, at.v + passage.dv, passage.into};
    if (static_cast<unsigned>(at.u) >= columns || static_cast<unsigned>(at.v) >= rows) {
      add_crossing(points[below], points[above], chain.points);
      chain.last = side_of(out);
      return;
    }
    if (at == start) {
      chain.closed = true;
      return;
    }
  }
}

}  // namespace limitgauge::engine::surface
