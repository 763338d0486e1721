#include "verifier/stock/mesh_side.h"

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>

#include "verifier/tolerance.h"

namespace limitgauge::verifier {
namespace {

using model::Box3;
using model::Vec3;

int sign(double x) {
  return (x > 0) - (x < 0);
}

int exact_turn(const Vec3& a, const Vec3& b, const Vec3& p) {
  using Rational = boost::multiprecision::cpp_rational;
  const Rational ax(a.x), ay(a.y);
  const Rational left = (Rational(b.x) - ax) * (Rational(p.y) - ay);
  const Rational right = (Rational(b.y) - ay) * (Rational(p.x) - ax);
  return left.compare(right);
}

/// Seen from above: 1 where p lies left of the line from a to b, −1 right of it. On the line, as
/// p + (ε, ε²) lies; 0 only where a and b are one point. Antisymmetric in a and b.
int turn(const Vec3& a, const Vec3& b, const Vec3& p) {
  const double left = (b.x - a.x) * (p.y - a.y), right = (b.y - a.y) * (p.x - a.x);
  const double det = left - right, sum = std::abs(left) + std::abs(right);
  if (std::abs(det) > kOrientationRounding * sum) return sign(det);
  // Straight above an end of the edge, as for every point above a vertex, no sum is needed.
  const bool above_end = (p.x == a.x && p.y == a.y) || (p.x == b.x && p.y == b.y);
  if (sum > 0 && !above_end)
    if (const int exact = exact_turn(a, b, p); exact != 0) return exact > 0 ? 1 : -1;
  if (b.y != a.y) return b.y < a.y ? 1 : -1;
  return sign(b.x - a.x);
}

/// 1 where the vertical upwards from p leaves through the triangle, −1 where it enters, 0 where it
/// misses it.
int crossing(const Triangle& t, const Vec3& p) {
  const int first = turn(t[0], t[1], p);
  if (first == 0 || turn(t[1], t[2], p) != first || turn(t[2], t[0], p) != first) return 0;
  const Vec3 normal = cross(t[1] - t[0], t[2] - t[0]);
  return dot(normal, t[0] - p) * first > 0 ? first : 0;
}

}  // namespace

MeshSide::MeshSide(const TriangleTree& tree) : tree_(&tree) {
  // A few cells for a triangle, between a coarse grid and two million.
  const double along =
      std::clamp(std::cbrt(16.0 * static_cast<double>(tree.triangles().size())), 16.0, 128.0);
  const Vec3 size = tree.box().size();
  const double longest = std::max({size.x, size.y, size.z});
  if (!(longest > 0)) return;
  size_mm_ = longest / std::floor(along);
  for (int axis = 0; axis < 3; ++axis)
    counts_[axis] = static_cast<std::int64_t>(size[axis] / size_mm_) + 1;
  cells_.assign(static_cast<std::size_t>(counts_[0] * counts_[1] * counts_[2]), Cell::unknown);
  for (const Triangle& t : tree.triangles()) mark(t);
  // Cells that share a face, and that no triangle comes near, lie on the same side.
  for (std::size_t cell = 0; cell < cells_.size(); ++cell)
    if (cells_[cell] == Cell::unknown)
      fill(cell, winds_around(centre(cell)) ? Cell::inside : Cell::outside);
}

std::size_t MeshSide::index(std::int64_t i, std::int64_t j, std::int64_t k) const {
  return static_cast<std::size_t>((k * counts_[1] + j) * counts_[0] + i);
}

Vec3 MeshSide::centre(std::size_t cell) const {
  const auto at = static_cast<std::int64_t>(cell);
  const Vec3 place{static_cast<double>(at % counts_[0]),
                   static_cast<double>(at / counts_[0] % counts_[1]),
                   static_cast<double>(at / (counts_[0] * counts_[1]))};
  return tree_->box().low + (place + Vec3{0.5, 0.5, 0.5}) * size_mm_;
}

std::int64_t MeshSide::place(int axis, double at) const {
  const double cells = std::floor((at - tree_->box().low[axis]) / size_mm_);
  return std::clamp(static_cast<std::int64_t>(cells), std::int64_t{0}, counts_[axis] - 1);
}

void MeshSide::mark(const Triangle& t) {
  Box3 box;
  for (const Vec3& corner : t) box.add(corner);
  box = box.grown(kMeshCellMargin * size_mm_);
  const Vec3 n = cross(t[1] - t[0], t[2] - t[0]);
  // A large triangle at a slant passes few of the cells of its box.
  const double half = (0.5 + kMeshCellMargin) * size_mm_;
  const double near =
      half * (std::abs(n.x) + std::abs(n.y) + std::abs(n.z)) * (1 + kMeshCellMargin);
  for (std::int64_t k = place(2, box.low.z); k <= place(2, box.high.z); ++k)
    for (std::int64_t j = place(1, box.low.y); j <= place(1, box.high.y); ++j)
      for (std::int64_t i = place(0, box.low.x); i <= place(0, box.high.x); ++i) {
        const std::size_t cell = index(i, j, k);
        if (std::abs(dot(n, centre(cell) - t[0])) <= near) cells_[cell] = Cell::mixed;
      }
}

void MeshSide::fill(std::size_t first, Cell side) {
  std::vector<std::size_t> open{first};
  cells_[first] = side;
  const std::size_t strides[] = {1, static_cast<std::size_t>(counts_[0]),
                                 static_cast<std::size_t>(counts_[0] * counts_[1])};
  while (!open.empty()) {
    const std::size_t cell = open.back();
    open.pop_back();
    const auto visit = [&](std::size_t other) {
      if (cells_[other] != Cell::unknown) return;
      cells_[other] = side;
      open.push_back(other);
    };
    for (int axis = 0; axis < 3; ++axis) {
      const auto at = static_cast<std::int64_t>(cell / strides[axis]) % counts_[axis];
      if (at > 0) visit(cell - strides[axis]);
      if (at + 1 < counts_[axis]) visit(cell + strides[axis]);
    }
  }
}

bool MeshSide::inside(const Vec3& p) const {
  const Box3& box = tree_->box();
  if (cells_.empty() || !box.contains(p)) return false;
  const Cell cell = cells_[index(place(0, p.x), place(1, p.y), place(2, p.z))];
  return cell == Cell::mixed ? winds_around(p) : cell == Cell::inside;
}

bool MeshSide::winds_around(const Vec3& p) const {
  thread_local std::vector<std::uint32_t> stack;
  const std::vector<model::BoxNode>& nodes = tree_->nodes();
  stack.assign(1, 0);
  int turns = 0;
  while (!stack.empty()) {
    const std::uint32_t at = stack.back();
    stack.pop_back();
    const model::BoxNode& node = nodes[at];
    const Box3& b = node.box;
    if (p.x < b.low.x || p.x > b.high.x || p.y < b.low.y || p.y > b.high.y || p.z > b.high.z)
      continue;
    if (node.count == 0) {
      stack.push_back(node.right);
      stack.push_back(at + 1);
    }
    for (std::uint32_t k = node.first; k < node.first + node.count; ++k)
      turns += crossing(tree_->triangles()[k], p);
  }
  return turns > 0;
}

}  // namespace limitgauge::verifier
