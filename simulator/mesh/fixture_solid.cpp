#include "simulator/mesh/fixture_solid.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "simulator/sweep/depth_bound.h"

namespace limitgauge::simulator {
namespace {

using model::Box3;
using model::TriangleMesh;
using model::Vec3;

constexpr std::uint32_t kLeafTriangles = 4;
// A median split halves 2^32 triangles in fewer levels than this, with one node waiting a level.
constexpr std::size_t kDeepest = 64;

void require_known_vertices(const TriangleMesh& mesh) {
  for (const auto& triangle : mesh.triangles)
    for (const std::uint32_t v : triangle)
      if (v >= mesh.vertices.size())
        throw std::invalid_argument("a fixture's triangle has a vertex that does not exist");
  if (!std::all_of(mesh.vertices.begin(), mesh.vertices.end(),
                   [](const Vec3& v) { return is_finite(v); }))
    throw std::invalid_argument("a fixture with a coordinate that is not finite");
}

// Closed: every edge is gone along as often one way as the other.
void require_closed(const TriangleMesh& mesh) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> forth, back;
  for (const auto& t : mesh.triangles)
    for (int i = 0; i < 3; ++i) {
      const std::uint32_t a = t[i], b = t[(i + 1) % 3];
      if (a < b) forth.emplace_back(a, b);
      if (b < a) back.emplace_back(b, a);
    }
  std::sort(forth.begin(), forth.end());
  std::sort(back.begin(), back.end());
  if (forth != back) throw std::invalid_argument("a fixture's mesh is not closed");
}

Box3 box_of(const TriangleCorners& c) {
  Box3 box;
  for (const Vec3& corner : c) box.add(corner);
  return box;
}

// The swept distance is convex: over a box it is nowhere below its tangent at the middle.
double lower_bound(const CutterProfile& body, const SweptMove& move, const Box3& box) {
  const SweptSample s = swept_distance(body, move, box.centre());
  return s.distance - support(box.size() * 0.5, s.gradient);
}

// Twice the area, seen along Z, of p and the edge from a to b; of either sense of the edge exactly
// the same but for its sign.
double side_of(const Vec3& a, const Vec3& b, const Vec3& p) {
  if (std::pair(b.x, b.y) < std::pair(a.x, a.y)) return -side_of(b, a, p);
  return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
}

// How often the triangle goes around p, seen along Z. An edge counts where it crosses the level ray
// from p to the right; its lower end belongs to it.
int winding(const TriangleCorners& c, const Vec3& p) {
  int turns = 0;
  for (int i = 0; i < 3; ++i) {
    const Vec3 &a = c[i], &b = c[(i + 1) % 3];
    if (a.y <= p.y && b.y > p.y && side_of(a, b, p) > 0) ++turns;
    if (b.y <= p.y && a.y > p.y && side_of(b, a, p) > 0) --turns;
  }
  return turns;
}

bool is_above(const TriangleCorners& c, const Vec3& p) {
  const Vec3 n = cross(c[1] - c[0], c[2] - c[0]);
  // Of a triangle that stands upright any height of its own will do: p is not on it.
  if (n.z == 0) return (c[0].z + c[1].z + c[2].z) / 3 > p.z;
  return c[0].z - (n.x * (p.x - c[0].x) + n.y * (p.y - c[0].y)) / n.z > p.z;
}

}  // namespace

FixtureSolid::FixtureSolid(std::shared_ptr<const TriangleMesh> mesh) : mesh_(std::move(mesh)) {
  if (!mesh_ || mesh_->triangles.empty())
    throw std::invalid_argument("a fixture without triangles");
  require_known_vertices(*mesh_);
  require_closed(*mesh_);
  order_.resize(mesh_->triangles.size());
  std::iota(order_.begin(), order_.end(), 0U);
  nodes_.reserve(order_.size());
  nodes_.emplace_back();
  build(0, 0, static_cast<std::uint32_t>(order_.size()));
}

TriangleCorners FixtureSolid::corners(std::uint32_t at) const {
  const auto& t = mesh_->triangles[order_[at]];
  return {mesh_->vertices[t[0]], mesh_->vertices[t[1]], mesh_->vertices[t[2]]};
}

void FixtureSolid::build(std::uint32_t at, std::uint32_t begin, std::uint32_t end) {
  Box3 box, centres;
  for (std::uint32_t i = begin; i < end; ++i) {
    box.add(box_of(corners(i)));
    centres.add(box_of(corners(i)).centre());
  }
  nodes_[at] = {box, begin, end - begin};
  if (end - begin <= kLeafTriangles) return;
  const Vec3 size = centres.size();
  int axis = size.y > size.x ? 1 : 0;
  if (size.z > size[axis]) axis = 2;
  std::vector<std::pair<double, std::uint32_t>> keyed;
  for (std::uint32_t i = begin; i < end; ++i)
    keyed.emplace_back(box_of(corners(i)).centre()[axis], order_[i]);
  const std::uint32_t half = (end - begin) / 2;
  std::nth_element(keyed.begin(), keyed.begin() + half, keyed.end());
  for (std::uint32_t i = begin; i < end; ++i) order_[i] = keyed[i - begin].second;
  const auto children = static_cast<std::uint32_t>(nodes_.size());
  nodes_.resize(nodes_.size() + 2);
  nodes_[at].first = children;
  nodes_[at].count = 0;
  build(children, begin, begin + half);
  build(children + 1, begin + half, end);
}

std::optional<SurfacePlace> FixtureSolid::nearest(const CutterProfile& body, const SweptMove& move,
                                                  double bound, double precision_mm) const {
  std::optional<SurfacePlace> best;
  std::array<std::pair<double, std::uint32_t>, kDeepest> stack;
  std::size_t depth = 0;
  stack[depth++] = {lower_bound(body, move, box()), 0};
  while (depth > 0) {
    const auto [low, at] = stack[--depth];
    if (low >= bound) continue;
    const Node& node = nodes_[at];
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i)
      if (const auto place = least_on_triangle(body, move, corners(i), bound, precision_mm))
        best = place, bound = place->distance;
    if (node.count > 0) continue;
    std::pair near{lower_bound(body, move, nodes_[node.first].box), node.first};
    std::pair far{lower_bound(body, move, nodes_[node.first + 1].box), node.first + 1};
    if (far.first < near.first) std::swap(near, far);
    stack[depth++] = far;
    stack[depth++] = near;
  }
  return best;
}

bool FixtureSolid::encloses(const Vec3& p) const {
  int turns = 0;
  std::array<std::uint32_t, kDeepest> stack;
  std::size_t depth = 0;
  stack[depth++] = 0;
  while (depth > 0) {
    const Node& node = nodes_[stack[--depth]];
    const Box3& b = node.box;
    if (p.x < b.low.x || p.x > b.high.x || p.y < b.low.y || p.y > b.high.y || p.z > b.high.z)
      continue;
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
      const TriangleCorners c = corners(i);
      if (const int around = winding(c, p); around != 0 && is_above(c, p)) turns += around;
    }
    if (node.count > 0) continue;
    stack[depth++] = node.first;
    stack[depth++] = node.first + 1;
  }
  return turns != 0;
}

}  // namespace limitgauge::simulator
