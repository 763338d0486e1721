#include "verifier/feet/foot_tree.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

#include "model/geometry/box_tree.h"
#include "verifier/tolerance.h"

// Rounding. Let e = 2⁻²⁴, p − x the way from a query to a point of a box and M the size of the
// model. A local coordinate a·(p − c) is computed with an error of at most √3·e·(6·|p − c| + |c|) ≤
// 6.3e-7·|p − x| + 7.5e-7·M. Boxes are 1e-6·M larger on all sides, which covers the second term;
// the first, and the axes being orthonormal to a few e only, are below a relative 3e-6 of the
// squared distance, for which it is multiplied by kFootBoundShrink.

namespace limitgauge::verifier {
namespace {

using model::Box3;
using model::Vec3;

/// A box without room, far beyond everything: what a lane without a child holds.
constexpr float kNowhere = -1e15F;
/// Four more entries a level at most, and a tree of 2³¹ cells has 16 levels.
constexpr std::size_t kStack = 128;

struct Frame {
  std::array<Vec3, 3> axis = {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};
};
float rounded(double v) {
  return static_cast<float>(v);
}
Vec3 rounded(const Vec3& v) {
  return {rounded(v.x), rounded(v.y), rounded(v.z)};
}

/// Third axis along `normal`, first one in the plane of it and `along`.
Frame frame_of(const Vec3& normal, const Vec3& along) {
  Frame f;
  const Vec3 n = normalized(normal), a = normalized(along - n * dot(along, n));
  if (!(length_squared(n) > 0.5 && length_squared(a) > 0.5)) return f;
  f.axis = {rounded(a), rounded(cross(n, a)), rounded(n)};
  return f;
}

struct OrientedBox {
  Frame frame;
  Vec3 centre, half;
  double measure() const { return half.x * half.y + half.y * half.z + half.z * half.x; }
};

}  // namespace

/// Sorts the cells into nodes.
class FootTreeBuilder {
 public:
  explicit FootTreeBuilder(FootTree& tree) : tree_(tree) {
    Box3 all;
    for (const FootCell& cell : tree.cells_) {
      boxes_.push_back(control_box(cell.shape));
      all.add(boxes_.back());
    }
    if (boxes_.empty()) return;
    tree_.origin_ = all.centre();
    margin_ = kFootBoxMargin * length(all.size());
    order_.resize(boxes_.size());
    std::iota(order_.begin(), order_.end(), 0U);
    build(0, order_.size());
    std::vector<FootCell> sorted;
    sorted.reserve(order_.size());
    for (const std::uint32_t i : order_) sorted.push_back(tree.cells_[i]);
    tree_.cells_ = std::move(sorted);
  }

 private:
  using Range = std::array<std::size_t, 2>;

  std::uint32_t build(std::size_t begin, std::size_t end) {
    const auto here = static_cast<std::uint32_t>(tree_.nodes_.size());
    tree_.nodes_.emplace_back();
    for (auto& half : tree_.nodes_[here].half) half.fill(kNowhere);
    int k = 0;
    for (const Range& part : quarters(begin, end)) {
      const OrientedBox box = box_of(part[0], part[1]);
      const std::uint32_t child = part[1] - part[0] == 1
                                      ? static_cast<std::uint32_t>(part[0]) | FootTree::kLeaf
                                      : build(part[0], part[1]);
      set(tree_.nodes_[here], k++, box, child);
    }
    return here;
  }

  void set(FootTree::Node& node, int k, const OrientedBox& box, std::uint32_t child) const {
    for (int a = 0; a < 3; ++a) {
      node.centre[a][k] = rounded(box.centre[a]);
      node.half[a][k] = rounded(box.half[a] + margin_);
      for (int c = 0; c < 3; ++c) node.axis[a][c][k] = rounded(box.frame.axis[a][c]);
    }
    node.child[k] = child;
  }

  std::vector<Range> quarters(std::size_t begin, std::size_t end) {
    std::vector<Range> parts;
    for (const Range& half : halves(begin, end))
      for (const Range& quarter : halves(half[0], half[1])) parts.push_back(quarter);
    return parts;
  }

  std::vector<Range> halves(std::size_t begin, std::size_t end) {
    if (end - begin < 2) return {{begin, end}};
    model::halve_by_centres(std::span(order_).subspan(begin, end - begin), boxes_);
    const std::size_t half = begin + (end - begin) / 2;
    return {{begin, half}, {half, end}};
  }

  /// The smaller of the box along the coordinate axes and the one along the mean normal.
  OrientedBox box_of(std::size_t begin, std::size_t end) const {
    Vec3 normal, along;
    for (std::size_t i = begin; i < end; ++i) {
      const FootCell& cell = tree_.cells_[order_[i]];
      normal += cross(cell.middle.du, cell.middle.dv);
      // Sides are lines without direction: turned to agree before they are added up.
      for (const Vec3& side : {cell.middle.du, cell.middle.dv})
        if (length(side) > 0.5 * length(along)) along += dot(side, along) < 0 ? -side : side;
    }
    const OrientedBox straight = box_in({}, begin, end),
                      turned = box_in(frame_of(normal, along), begin, end);
    return turned.measure() < straight.measure() ? turned : straight;
  }

  OrientedBox box_in(const Frame& frame, std::size_t begin, std::size_t end) const {
    Box3 local;
    for (std::size_t i = begin; i < end; ++i) {
      const Bezier& shape = tree_.cells_[order_[i]].shape;
      for (int k = 0; k < 16; ++k) {
        const Vec3 q = shape.control(k) - tree_.origin_;
        local.add(Vec3{dot(q, frame.axis[0]), dot(q, frame.axis[1]), dot(q, frame.axis[2])});
      }
    }
    const Vec3 c = local.centre();
    OrientedBox box{
        frame, rounded(frame.axis[0] * c.x + frame.axis[1] * c.y + frame.axis[2] * c.z), {}};
    for (int a = 0; a < 3; ++a) {
      const double centre = dot(box.centre, frame.axis[a]);
      box.half[a] = std::max(local.high[a] - centre, centre - local.low[a]);
    }
    return box;
  }

  FootTree& tree_;
  std::vector<Box3> boxes_;
  std::vector<std::uint32_t> order_;
  double margin_ = 0;
};

FootTree::FootTree(const SurfaceTree& tree) : cells_(foot_cells(tree)) {
  FootTreeBuilder{*this};
}

FootTree::Lane FootTree::bounds(const Node& node, const std::array<float, 3>& p) const {
  Lane x, y, z, sum{};
  for (int k = 0; k < kWide; ++k) {
    x[k] = p[0] - node.centre[0][k];
    y[k] = p[1] - node.centre[1][k];
    z[k] = p[2] - node.centre[2][k];
  }
  for (int a = 0; a < 3; ++a)
    for (int k = 0; k < kWide; ++k) {
      const float along =
          x[k] * node.axis[a][0][k] + y[k] * node.axis[a][1][k] + z[k] * node.axis[a][2][k];
      const float beyond = std::abs(along) - node.half[a][k];
      const float gap = beyond > 0 ? beyond : 0;
      sum[k] += gap * gap;
    }
  for (float& v : sum) v *= kFootBoundShrink;
  return sum;
}

void FootTree::nearest(const Vec3& p, Foot& best) const {
  if (nodes_.empty()) return;
  search(p, best);
  if (best.cell == Foot::kNone || (best.aside_mm <= kSettled_mm && !best.at_crease)) return;
  // The cell that has the foot itself may have been left out as nearer within the tolerance only.
  const Vec3 place = point(cells_[best.cell].shape, best.s, best.t);
  each_near(place, kSettling_mm, [&](const FootCell& cell, const Foot&) {
    settle_in(cell, static_cast<std::uint32_t>(&cell - cells_.data()), p, place, best);
  });
}

void FootTree::search(const Vec3& p, Foot& best) const {
  struct Entry {
    std::uint32_t child;
    float bound;
  };
  std::array<Entry, kStack> stack;
  std::size_t size = 0;
  stack[size++] = {0, 0};
  const Vec3 at = p - origin_;
  const std::array<float, 3> q = {rounded(at.x), rounded(at.y), rounded(at.z)};
  while (size > 0) {
    const Entry entry = stack[--size];
    if (entry.bound >= best.squared) continue;
    if ((entry.child & kLeaf) != 0) {
      const std::uint32_t index = entry.child & ~kLeaf;
      nearer_in(cells_[index], index, p, best);
      continue;
    }
    const Node& node = nodes_[entry.child];
    const Lane bound = bounds(node, q);
    const std::size_t first = size;
    for (int k = 0; k < kWide; ++k) {
      if (node.child[k] == kNoChild || !(bound[k] < best.squared)) continue;
      // The nearest on top.
      std::size_t to = size++;
      for (; to > first && stack[to - 1].bound < bound[k]; --to) stack[to] = stack[to - 1];
      stack[to] = {node.child[k], bound[k]};
    }
  }
}

}  // namespace limitgauge::verifier
