#include "verifier/stock/triangle_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "model/geometry/box_tree.h"
#include "model/geometry/segment.h"
#include "verifier/tolerance.h"

namespace limitgauge::verifier {
namespace {

using model::Box3;
using model::Vec3;

constexpr std::uint32_t kLeafTriangles = 4;

Vec3 nearest_on_segment(const Vec3& a, const Vec3& b, const Vec3& p) {
  return a + (b - a) * model::nearest_share(p - a, b - a);
}

Vec3 nearest_on_edges(const Triangle& t, const Vec3& p) {
  Vec3 best = nearest_on_segment(t[0], t[1], p);
  for (const auto& [a, b] : {std::pair{1, 2}, std::pair{2, 0}}) {
    const Vec3 q = nearest_on_segment(t[a], t[b], p);
    if (length_squared(q - p) < length_squared(best - p)) best = q;
  }
  return best;
}

Triangle triangle_of(const model::TriangleMesh& mesh, std::size_t index) {
  Triangle t;
  for (int k = 0; k < 3; ++k) {
    const std::uint32_t vertex = mesh.triangles[index][k];
    if (vertex >= mesh.vertices.size())
      throw std::invalid_argument("a triangle of the mesh names a vertex that is not there");
    t[k] = mesh.vertices[vertex];
    if (!is_finite(t[k])) throw std::invalid_argument("a vertex of the mesh is not finite");
  }
  return t;
}

}  // namespace

Vec3 nearest_on_triangle(const Triangle& t, const Vec3& p) {
  const Vec3 ab = t[1] - t[0], ac = t[2] - t[0], ap = p - t[0], n = cross(ab, ac);
  const double area = dot(n, n);
  const double at_b = dot(cross(ap, ac), n), at_c = dot(cross(ab, ap), n);
  if (!(at_b > 0 && at_c > 0 && at_b + at_c < area)) return nearest_on_edges(t, p);
  const Vec3 foot = t[0] + ab * (at_b / area) + ac * (at_c / area);
  const double longest = std::max(dot(ab, ab), dot(ac, ac));
  if (area > kSliver * longest * longest) return foot;
  const Vec3 edge = nearest_on_edges(t, p);
  return length_squared(foot - p) < length_squared(edge - p) ? foot : edge;
}

TriangleTree::TriangleTree(const model::TriangleMesh& mesh) {
  if (mesh.triangles.empty()) throw std::invalid_argument("the mesh has no triangles");
  std::vector<Box3> boxes(mesh.triangles.size());
  for (std::size_t i = 0; i < boxes.size(); ++i)
    for (const Vec3& corner : triangle_of(mesh, i)) boxes[i].add(corner);
  model::BoxTree tree = model::box_tree(boxes, kLeafTriangles);
  nodes_ = std::move(tree.nodes);
  triangles_.reserve(boxes.size());
  for (const std::uint32_t i : tree.order) triangles_.push_back(triangle_of(mesh, i));
}

std::optional<TriangleTree::Foot> TriangleTree::nearest(const Vec3& p, double within_mm) const {
  std::optional<Foot> best;
  double squared = within_mm * within_mm;
  model::nearest_first(
      nodes_, [&](const model::BoxNode& node) { return distance_squared(node.box, p); },
      [&](double bound) { return bound > squared; },
      [&](const model::BoxNode& leaf) {
        for (std::uint32_t k = leaf.first; k < leaf.first + leaf.count; ++k) {
          const Vec3 q = nearest_on_triangle(triangles_[k], p);
          const double d = length_squared(q - p);
          if (d < squared || (d == squared && (!best || k < best->triangle)))
            squared = d, best = Foot{k, q, 0};
        }
      });
  if (best) best->distance_mm = std::sqrt(squared);
  return best;
}

namespace {

/// Where a ray enters a box; infinite where it passes by.
double entry_mm(const Box3& box, const Vec3& p, const Vec3& ray) {
  constexpr double kNever = std::numeric_limits<double>::infinity();
  double in = 0, out = kNever;
  for (int axis = 0; axis < 3; ++axis) {
    if (ray[axis] == 0) {
      if (p[axis] < box.low[axis] || p[axis] > box.high[axis]) return kNever;
      continue;
    }
    const double a = (box.low[axis] - p[axis]) / ray[axis],
                 b = (box.high[axis] - p[axis]) / ray[axis];
    in = std::max(in, std::min(a, b)), out = std::min(out, std::max(a, b));
  }
  return in <= out ? in : kNever;
}

/// The same as first_near() of one triangle. Its distance is convex along the ray, so that the zero
/// of a tangent comes before its own.
double first_near_triangle(const Triangle& t, const Vec3& p, const Vec3& ray, double limit_mm,
                           double within_mm) {
  constexpr int kMostSteps = 100;
  double at = 0;
  for (int step = 0; step < kMostSteps && at < limit_mm; ++step) {
    const Vec3 x = p + ray * at, from = x - nearest_on_triangle(t, x);
    const double distance = length(from);
    if (distance <= within_mm) return at;
    const double closing = -dot(from, ray) / distance;
    if (closing <= 0) return limit_mm;
    at += std::max(distance - within_mm, kDistanceRounding_mm / 2) / closing;
  }
  return std::min(at, limit_mm);
}

}  // namespace

double TriangleTree::first_near(const Vec3& p, const Vec3& ray, double limit_mm,
                                double within_mm) const {
  double first = limit_mm;
  const double margin = within_mm + kDistanceRounding_mm;
  model::nearest_first(
      nodes_, [&](const model::BoxNode& node) { return entry_mm(node.box.grown(margin), p, ray); },
      [&](double entry) { return entry >= first; },
      [&](const model::BoxNode& leaf) {
        for (std::uint32_t k = leaf.first; k < leaf.first + leaf.count; ++k)
          first = first_near_triangle(triangles_[k], p, ray, first, within_mm);
      });
  return first;
}

}  // namespace limitgauge::verifier
