#include "simulator/mesh/mesh_tree.h"

// A check of CGAL's own that fails would print and throw; what the tree is asked is sound, and the
// bounds of a search need not shrink from box to box as one of the checks has it.
#ifndef CGAL_NDEBUG
#define CGAL_NDEBUG
#endif
#include <CGAL/AABB_tree.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/version.h>
#if CGAL_VERSION_NR >= 1060000000
#include <CGAL/AABB_traits_3.h>
#include <CGAL/AABB_triangle_primitive_3.h>
#else
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_triangle_primitive.h>
#endif

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include "model/geometry/box_tree.h"
#include "simulator/tolerance.h"

namespace limitgauge::simulator {
namespace {

using model::Box3;
using model::Vec3;
using Passage = MeshTree::Passage;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point2 = Kernel::Point_2;
using Point3 = Kernel::Point_3;
using Triangle3 = Kernel::Triangle_3;
using Place = std::vector<Triangle3>::const_iterator;
#if CGAL_VERSION_NR >= 1060000000
using Primitive = CGAL::AABB_triangle_primitive_3<Kernel, Place>;
using TreeTraits = CGAL::AABB_traits_3<Kernel, Primitive>;
#else
using Primitive = CGAL::AABB_triangle_primitive<Kernel, Place>;
using TreeTraits = CGAL::AABB_traits<Kernel, Primitive>;
#endif
using Tree = CGAL::AABB_tree<TreeTraits>;
using Node = CGAL::AABB_node<TreeTraits>;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

Point3 point3(const Vec3& p) {
  return {p.x, p.y, p.z};
}
Point2 flat(const Point3& p) {
  return {p.x(), p.y()};
}
Vec3 vec3(const Point3& p) {
  return {p.x(), p.y(), p.z()};
}
Box3 box3(const CGAL::Bbox_3& b) {
  return {{b.xmin(), b.ymin(), b.zmin()}, {b.xmax(), b.ymax(), b.zmax()}};
}

// A triangle by its longest edge and the height on that.
struct Sliver {
  Vec3 a, b, c;               // a to b is the longest edge
  Vec3 along;                 // of the longest edge, unit
  Vec3 height;                // from the longest edge to c
  double length_mm, foot_mm;  // of the longest edge; from a to the foot of the height
};

Sliver by_longest_edge(const Triangle3& t) {
  int k = 0;
  for (int i = 1; i < 3; ++i)
    if (CGAL::squared_distance(t[i], t[i + 1]) > CGAL::squared_distance(t[k], t[k + 1])) k = i;
  Sliver s{vec3(t[k]), vec3(t[k + 1]), vec3(t[k + 2]), {}, {}, 0, 0};
  s.length_mm = distance(s.a, s.b);
  if (s.length_mm > 0) s.along = (s.b - s.a) / s.length_mm;
  s.foot_mm = dot(s.c - s.a, s.along);
  s.height = s.c - s.a - s.foot_mm * s.along;
  return s;
}

bool is_sliver(const Triangle3& t) {
  const Sliver s = by_longest_edge(t);
  const double second_mm = std::max(distance(s.a, s.c), distance(s.b, s.c));
  return !(length(s.height) > kSliverSine * second_mm);
}

// As many triangles are taken together, without boxes of their own.
constexpr std::ptrdiff_t kGroup = 4;

// Halves at the median of the boxes' middles, where CGAL would take that of the triangles' first
// corners. Groups keep their order, so that of equally good places a search finds the same one for
// every release of CGAL.
struct Halve {
  template <class Iterator>
  void operator()(Iterator begin, Iterator end, const CGAL::Bbox_3&) const {
    if (end - begin <= kGroup) return;
    model::halve_by_place(
        std::span<Primitive>(begin, end),
        [](const Primitive& t) { return box3(t.id()->bbox()).centre(); },
        [](const Primitive& t) { return t.id(); });
  }
};

// The point of a sliver above whose inside p lies, if it does: the distance to it is exact but for
// rounding (PROOFS.md, P4).
std::optional<Vec3> foot_inside(const Triangle3& t, const Vec3& p) {
  const Sliver s = by_longest_edge(t);
  const double square = length_squared(s.height);
  if (!(square > 0)) return {};
  const Vec3 from_a = p - s.a;
  const double at_mm = dot(from_a, s.along);
  const double up = dot(from_a - at_mm * s.along, s.height) / square;
  const double on = (at_mm - up * s.foot_mm) / s.length_mm;
  if (!(up > 0 && on > 0 && up + on < 1)) return {};
  return s.a + up * (s.c - s.a) + on * (s.b - s.a);
}

// The nearest point of a sliver: of its edges, or inside.
Vec3 foot_on_sliver(const Triangle3& t, const Vec3& p) {
  const auto foot = Kernel().construct_projected_point_3_object();
  Vec3 best = vec3(t[0]);
  const auto take = [&](const Vec3& q) {
    if (length_squared(p - q) < length_squared(p - best)) best = q;
  };
  for (int k = 0; k < 3; ++k) take(vec3(foot(Kernel::Segment_3(t[k], t[k + 1]), point3(p))));
  if (const std::optional<Vec3> inside = foot_inside(t, p)) take(*inside);
  return best;
}

// How often the triangle, seen from above, goes around the vertical at p: +1 where it faces
// upwards, −1 downwards, 0 where it misses it. A vertex at the height y of p counts as below it
// and a point on an edge as left of it: as if p lay a little to +X and far less to +Y of where it
// is. Over the triangles of a closed mesh the sum is exactly zero.
int turns_about(const Triangle3& t, const Point2& p) {
  int turns = 0;
  for (int k = 0; k < 3; ++k) {
    const Point3 &a = t[k], &b = t[k + 1];
    const bool from_above = a.y() > p.y(), to_above = b.y() > p.y();
    if (from_above == to_above) continue;
    const CGAL::Orientation side = CGAL::orientation(flat(a), flat(b), p);
    if (to_above && side == CGAL::LEFT_TURN) ++turns;
    if (from_above && side == CGAL::RIGHT_TURN) --turns;
  }
  return turns;
}

bool plane_above(const Triangle3& t, int turns, const Point3& p) {
  if (p.z() < std::min({t[0].z(), t[1].z(), t[2].z()})) return true;
  if (p.z() >= std::max({t[0].z(), t[1].z(), t[2].z()})) return false;
  const CGAL::Orientation side = CGAL::orientation(t[0], t[1], t[2], p);
  return side == (turns > 0 ? CGAL::NEGATIVE : CGAL::POSITIVE);
}

}  // namespace

struct MeshTree::State {
  std::vector<Triangle3> triangles;
  std::vector<bool> slivers;
  Tree tree;
  Box3 box;

  explicit State(const model::TriangleMesh& mesh) : box(bounding_box(mesh)) {
    triangles.reserve(mesh.triangles.size());
    for (const auto& [a, b, c] : mesh.triangles)
      triangles.emplace_back(point3(mesh.vertices[a]), point3(mesh.vertices[b]),
                             point3(mesh.vertices[c]));
    slivers.reserve(triangles.size());
    for (const Triangle3& t : triangles) slivers.push_back(is_sliver(t));
    tree.insert(triangles.cbegin(), triangles.cend());
    tree.custom_build(tree.traits().compute_bbox_object(), Halve());
  }

  std::uint32_t number(const Primitive& primitive) const {
    return static_cast<std::uint32_t>(primitive.id() - triangles.cbegin());
  }
  Vec3 foot(std::uint32_t n, const Vec3& p) const {
    if (slivers[n]) return foot_on_sliver(triangles[n], p);
    return vec3(Kernel().construct_projected_point_3_object()(triangles[n], point3(p)));
  }
};

namespace {

// What CGAL's tree calls on its way: `do_intersect` whether to go into a node, with a priority
// where nodes are to be taken in order, `intersection` for each triangle of the nodes gone into.

template <class State>
struct NearestWalk {
  using Priority = double;
  const State& state;
  MeshTree::Nearest best{0, {}, kInfinity};

  bool go_further() const { return true; }
  void look_at(const Vec3& p, std::uint32_t n) {
    const Vec3 q = state.foot(n, p);
    const double d = length_squared(p - q);
    if (d < best.distance_squared) best = {n, q, d};
  }
  void intersection(const Vec3& p, const Primitive& primitive) {
    look_at(p, state.number(primitive));
  }
  bool do_intersect(const Vec3& p, const Node& node) const {
    return distance_squared(box3(node.bbox()), p) < best.distance_squared;
  }
  std::pair<bool, Priority> do_intersect_with_priority(const Vec3& p, const Node& node) const {
    const double d = distance_squared(box3(node.bbox()), p);
    return {d < best.distance_squared, -d};
  }
};

// Of the vertical, the part at p.z or above.
template <class Visit>
struct VerticalWalk {
  const Visit& visit;

  bool go_further() const { return true; }
  void intersection(const Point3& p, const Primitive& primitive) {
    if (const int turns = turns_about(*primitive.id(), flat(p)); turns != 0)
      visit(primitive, turns);
  }
  bool do_intersect(const Point3& p, const Node& node) const {
    const CGAL::Bbox_3 b = node.bbox();
    return p.x() >= b.xmin() && p.x() <= b.xmax() && p.y() >= b.ymin() && p.y() <= b.ymax() &&
           p.z() <= b.zmax();
  }
};

template <class State>
struct CubeWalk {
  const State& state;
  double half_edge;
  const std::function<bool(std::uint32_t)>& visit;
  bool all = true;

  bool go_further() const { return all; }
  void intersection(const Vec3&, const Primitive& primitive) {
    all = all && visit(state.number(primitive));
  }
  bool do_intersect(const Vec3& p, const Node& node) const {
    const CGAL::Bbox_3 b = node.bbox();
    for (int a = 0; a < 3; ++a)
      if (p[a] + half_edge < b.min(a) || p[a] - half_edge > b.max(a)) return false;
    return true;
  }
};

struct Nothing {};

template <class State>
struct SearchWalk {
  using Priority = double;
  const State& state;
  double least;
  const std::function<double(const Box3&)>& least_in;
  const std::function<double(std::uint32_t)>& look;

  bool go_further() const { return true; }
  void intersection(Nothing, const Primitive& primitive) { least = look(state.number(primitive)); }
  template <class Iterator>
  void traverse_group(Nothing, Iterator begin, Iterator end) {
    for (; begin != end; ++begin) intersection({}, *begin);
  }
  bool do_intersect(Nothing, const Node& node) const { return least_in(box3(node.bbox())) < least; }
  std::pair<bool, Priority> do_intersect_with_priority(Nothing, const Node& node) const {
    const double low = least_in(box3(node.bbox()));
    return {low < least, -low};
  }
};

template <class Tree, class Visit>
void walk_up(const Tree& tree, const Point3& p, const Visit& visit) {
  VerticalWalk<Visit> walk{visit};
  tree.traversal(p, walk);
}

}  // namespace

MeshTree::MeshTree(const model::TriangleMesh& mesh) : state_(std::make_shared<const State>(mesh)) {}

MeshTree::Nearest MeshTree::nearest(const Vec3& p, std::optional<std::uint32_t> first_look) const {
  NearestWalk<State> walk{*state_};
  if (first_look) walk.look_at(p, *first_look);
  state_->tree.traversal_with_priority(p, walk);
  return walk.best;
}

double MeshTree::distance_to(std::uint32_t triangle, const Vec3& p) const {
  return distance(state_->foot(triangle, p), p);
}

std::vector<Passage> MeshTree::passages_above(const Vec3& p) const {
  std::vector<Passage> found;
  const Point3 from = point3(p);
  walk_up(state_->tree, from, [&](const Primitive& primitive, int turns) {
    if (plane_above(*primitive.id(), turns, from))
      found.push_back({state_->number(primitive), turns});
  });
  return found;
}

std::vector<Passage> MeshTree::passages(double x_mm, double y_mm) const {
  return passages_above({x_mm, y_mm, std::nextafter(box().low.z, -kInfinity)});
}

bool MeshTree::is_above(const Passage& passage, const Vec3& p) const {
  return plane_above(state_->triangles[passage.triangle], passage.turns, point3(p));
}

int MeshTree::winding(const Vec3& p) const {
  int sum = 0;
  const Point3 from = point3(p);
  walk_up(state_->tree, from, [&](const Primitive& primitive, int turns) {
    if (plane_above(*primitive.id(), turns, from)) sum += turns;
  });
  return sum;
}

bool MeshTree::each_about(const Vec3& p, double half_edge_mm,
                          const std::function<bool(std::uint32_t)>& visit) const {
  CubeWalk<State> walk{*state_, half_edge_mm, visit};
  state_->tree.traversal(p, walk);
  return walk.all;
}

void MeshTree::search(double least, const std::function<double(const Box3&)>& least_in,
                      const std::function<double(std::uint32_t)>& look) const {
  SearchWalk<State> walk{*state_, least, least_in, look};
  state_->tree.traversal_with_priority_and_group_traversal(Nothing{}, walk, kGroup);
}

MeshTree::Triangle MeshTree::triangle(std::uint32_t number) const {
  const Triangle3& t = state_->triangles[number];
  return {vec3(t[0]), vec3(t[1]), vec3(t[2])};
}

const Box3& MeshTree::box() const {
  return state_->box;
}

std::size_t MeshTree::memory_bytes() const {
  return state_->triangles.capacity() * (sizeof(Triangle3) + sizeof(Primitive) + sizeof(Node));
}

}  // namespace limitgauge::simulator
