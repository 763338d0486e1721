#include "verifier/stock/triangle_tree.h"

#include <algorithm>
#include <cmath>
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

}  // namespace limitgauge::verifier
