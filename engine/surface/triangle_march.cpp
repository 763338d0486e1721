#include "engine/surface/triangle_march.h"

#include <array>

namespace limitgauge::engine::surface {
namespace {

using Kind = GridEdge::Kind;

std::array<GridEdge, 3> edges_of(int triangle, int columns) {
  const int cell = triangle / 2, u = cell % (columns - 1), v = cell / (columns - 1);
  if (triangle % 2 == 0)
    return {GridEdge{Kind::right, u, v}, {Kind::up, u + 1, v}, {Kind::diagonal, u, v}};
  return {GridEdge{Kind::diagonal, u, v}, {Kind::right, u, v + 1}, {Kind::up, u, v}};
}

}  // namespace

const Vec3& TriangleMarch::to(const GridEdge& e) const {
  return grid_.at(e.u + (e.kind != Kind::up), e.v + (e.kind != Kind::right));
}

bool TriangleMarch::crossed(const GridEdge& e) const {
  return plane_.above(from(e)) != plane_.above(to(e));
}

bool TriangleMarch::on_side(const GridEdge& e) const {
  if (e.kind == Kind::right) return e.v == 0 || e.v == grid_.rows - 1;
  return e.kind == Kind::up && (e.u == 0 || e.u == grid_.columns - 1);
}

bool TriangleMarch::crosses(int triangle) const {
  for (const GridEdge& e : edges_of(triangle, grid_.columns))
    if (crossed(e)) return true;
  return false;
}

std::optional<GridEdge> TriangleMarch::side_edge(int triangle) const {
  for (const GridEdge& e : edges_of(triangle, grid_.columns))
    if (on_side(e) && crossed(e)) return e;
  return std::nullopt;
}

GridEdge TriangleMarch::any_edge(int triangle) const {
  const auto edges = edges_of(triangle, grid_.columns);
  return crossed(edges[0]) ? edges[0] : edges[1];
}

GridEdge TriangleMarch::exit(int triangle, const GridEdge& entry) const {
  const auto edges = edges_of(triangle, grid_.columns);
  for (const GridEdge& e : edges)
    if (e != entry && crossed(e)) return e;
  return entry;
}

std::optional<int> TriangleMarch::across(int triangle, const GridEdge& e) const {
  if (on_side(e)) return std::nullopt;
  const int row = grid_.columns - 1;
  const int lower = 2 * (e.v * row + e.u);
  switch (e.kind) {
    case Kind::diagonal:
      return triangle == lower ? lower + 1 : lower;
    case Kind::right:
      return triangle == lower ? lower - 2 * row + 1 : lower;
    case Kind::up:
      break;
  }
  return triangle == lower + 1 ? lower - 2 : lower + 1;
}

Vec3 TriangleMarch::point(const GridEdge& e) const {
  const Vec3 &a = from(e), &b = to(e);
  const int axis = plane_.axis;
  const double t = (plane_.value - a[axis]) / (b[axis] - a[axis]);
  Vec3 p = lerp(a, b, t);
  p[axis] = plane_.value;
  return p;
}

SectionEnd TriangleMarch::end(const GridEdge& e) const {
  if (e.kind == Kind::right) return {e.v == 0 ? 0 : 2, e.u};
  return {e.u == 0 ? 3 : 1, e.v};
}

}  // namespace limitgauge::engine::surface
