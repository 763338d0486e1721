#include "simulator/mesh/mesh_tree.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <span>

namespace limitgauge::simulator {
namespace {

using model::Box3;
using model::Vec3;

constexpr std::uint32_t kLeafTriangles = 4;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

Vec3 nearest_on_segment(const Vec3& a, const Vec3& b, const Vec3& p) {
  const Vec3 ab = b - a;
  const double along = dot(ab, p - a), whole = length_squared(ab);
  if (along <= 0) return a;
  return along >= whole ? b : a + ab * (along / whole);
}

// In a sliver rounding decides which region a point is in; its edges are then near enough to tell.
Vec3 nearest_of_sliver(const std::array<Vec3, 3>& t, const Vec3& in_face, const Vec3& p) {
  Vec3 best = in_face;
  for (int k = 0; k < 3; ++k) {
    const Vec3 q = nearest_on_segment(t[k], t[(k + 1) % 3], p);
    if (length_squared(p - q) < length_squared(p - best)) best = q;
  }
  return best;
}

}  // namespace

// C. Ericson, Real-Time Collision Detection, 5.1.5: by the regions of corners, edges and face.
Vec3 nearest_on_triangle(const std::array<Vec3, 3>& t, const Vec3& p) {
  const auto& [a, b, c] = t;
  const Vec3 ab = b - a, ac = c - a, ap = p - a;
  const double d1 = dot(ab, ap), d2 = dot(ac, ap);
  if (d1 <= 0 && d2 <= 0) return a;
  const Vec3 bp = p - b;
  const double d3 = dot(ab, bp), d4 = dot(ac, bp);
  if (d3 >= 0 && d4 <= d3) return b;
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return a + ab * (d1 / (d1 - d3));
  const Vec3 cp = p - c;
  const double d5 = dot(ab, cp), d6 = dot(ac, cp);
  if (d6 >= 0 && d5 <= d6) return c;
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return a + ac * (d2 / (d2 - d6));
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 >= d3 && d5 >= d6) return b + (c - b) * ((d4 - d3) / ((d4 - d3) + (d5 - d6)));
  // The squared sine of the angle at a below which the weights have lost half their digits.
  constexpr double kSliver = 1e-8;
  const double whole = va + vb + vc;
  const Vec3 in_face = a + ab * (vb / whole) + ac * (vc / whole);
  if (whole > kSliver * length_squared(ab) * length_squared(ac)) return in_face;
  return nearest_of_sliver(t, is_finite(in_face) ? in_face : a, p);
}

struct MeshTree::Builder {
  MeshTree& tree;
  const model::TriangleMesh& mesh;
  std::vector<Vec3> middles;
  std::vector<std::uint32_t> order;

  Triangle corners(std::uint32_t t) const {
    const auto& [a, b, c] = mesh.triangles[t];
    return {mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]};
  }

  void build() {
    const auto count = static_cast<std::uint32_t>(mesh.triangles.size());
    middles.reserve(count), order.resize(count);
    std::iota(order.begin(), order.end(), 0U);
    for (std::uint32_t t = 0; t < count; ++t) {
      const Triangle c = corners(t);
      middles.push_back((c[0] + c[1] + c[2]) / 3.0);
    }
    tree.triangles_.reserve(count);
    add_node(order);
  }

  // Cuts at the median across the axis in which the middles spread most.
  std::size_t halve(std::span<std::uint32_t> part) {
    Box3 box;
    for (const std::uint32_t t : part) box.add(middles[t]);
    const Vec3 size = box.size();
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const std::size_t half = part.size() / 2;
    std::nth_element(part.begin(), part.begin() + static_cast<std::ptrdiff_t>(half), part.end(),
                     [&](std::uint32_t a, std::uint32_t b) {
                       const double x = middles[a][axis], y = middles[b][axis];
                       return x != y ? x < y : a < b;
                     });
    return half;
  }

  std::uint32_t add_node(std::span<std::uint32_t> part) {
    const auto number = static_cast<std::uint32_t>(tree.nodes_.size());
    Node& node = tree.nodes_.emplace_back();
    for (auto& axis : node.low) axis.fill(kInfinity);
    for (auto& axis : node.high) axis.fill(-kInfinity);
    node.first.fill(0), node.count.fill(0);
    int used = 0;
    if (part.size() <= kLeafTriangles) {
      add_child(number, used, part);
      return number;
    }
    const std::size_t half = halve(part);
    for (const auto two : {part.first(half), part.subspan(half)}) {
      if (two.size() <= kLeafTriangles) {
        add_child(number, used++, two);
        continue;
      }
      const std::size_t quarter = halve(two);
      add_child(number, used++, two.first(quarter));
      add_child(number, used++, two.subspan(quarter));
    }
    return number;
  }

  void add_child(std::uint32_t number, int k, std::span<std::uint32_t> part) {
    Box3 box;
    for (const std::uint32_t t : part)
      for (const Vec3& v : corners(t)) box.add(v);
    Node& node = tree.nodes_[number];
    for (int a = 0; a < 3; ++a) node.low[a][k] = box.low[a], node.high[a][k] = box.high[a];
    if (part.size() <= kLeafTriangles) {
      node.first[k] = static_cast<std::uint32_t>(tree.triangles_.size());
      node.count[k] = static_cast<std::uint32_t>(part.size());
      for (const std::uint32_t t : part) tree.triangles_.push_back(corners(t));
      return;
    }
    // Not through `node`: the nodes move as they grow.
    const std::uint32_t child = add_node(part);
    tree.nodes_[number].first[k] = child;
  }
};

MeshTree::MeshTree(const model::TriangleMesh& mesh) {
  Builder{*this, mesh, {}, {}}.build();
}

MeshTree::Nearest MeshTree::nearest(const Vec3& p, std::uint32_t hint) const {
  Nearest best{0, {}, kInfinity};
  const auto look_at = [&](std::uint32_t slot) {
    const Vec3 q = nearest_on_triangle(triangles_[slot], p);
    const double d = length_squared(p - q);
    if (d < best.distance_squared) best = {slot, q, d};
  };
  look_at(hint);
  struct Waiting {
    double distance_squared;
    std::uint32_t first, count;
  };
  std::array<Waiting, 128> stack;
  int depth = 0;
  stack[depth++] = {0, 0, 0};
  while (depth > 0) {
    const Waiting at = stack[--depth];
    if (at.distance_squared >= best.distance_squared) continue;
    if (at.count > 0) {
      for (std::uint32_t n = 0; n < at.count; ++n) look_at(at.first + n);
      continue;
    }
    const Node& node = nodes_[at.first];
    std::array<double, kWide> d{};
    for (int a = 0; a < 3; ++a)
      for (int k = 0; k < kWide; ++k) {
        const double away = std::max({node.low[a][k] - p[a], p[a] - node.high[a][k], 0.0});
        d[k] += away * away;
      }
    // The nearest child comes to lie on top.
    const int begin = depth;
    for (int k = 0; k < kWide; ++k) {
      if (d[k] >= best.distance_squared) continue;
      int place = depth++;
      for (; place > begin && stack[place - 1].distance_squared < d[k]; --place)
        stack[place] = stack[place - 1];
      stack[place] = {d[k], node.first[k], node.count[k]};
    }
  }
  return best;
}

std::size_t MeshTree::memory_bytes() const {
  return nodes_.capacity() * sizeof(Node) + triangles_.capacity() * sizeof(Triangle);
}

}  // namespace limitgauge::simulator
