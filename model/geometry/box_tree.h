#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "model/geometry/vec3.h"

namespace limitgauge::model {

/// The axis along which a box is longest; the first of several.
constexpr int longest_axis(const Vec3& size) {
  const int axis = size.y > size.x ? 1 : 0;
  return size.z > size[axis] ? 2 : axis;
}

/// Puts those elements of `part` first whose places come first along the longest side of the box
/// around all places, equal ones by number, and returns how many: half of them, rounded down. What
/// is in each half does not depend on the order that the elements came in. `place(element)` is a
/// point, `number(element)` differs from element to element.
template <class Element, class Place, class Number>
std::size_t halve_by_place(std::span<Element> part, const Place& place, const Number& number) {
  Box3 box;
  for (const Element& element : part) box.add(place(element));
  const int axis = longest_axis(box.size());
  const std::size_t half = part.size() / 2;
  const auto before = [&](const Element& a, const Element& b) {
    const double at_a = place(a)[axis], at_b = place(b)[axis];
    return at_a != at_b ? at_a < at_b : number(a) < number(b);
  };
  std::nth_element(part.begin(), part.begin() + static_cast<std::ptrdiff_t>(half), part.end(),
                   before);
  return half;
}

/// The same for elements that are numbers of boxes, by the boxes' centres.
std::size_t halve_by_centres(std::span<std::uint32_t> part, const std::vector<Box3>& boxes);

/// A node of a tree of boxes over elements that are given by number.
struct BoxNode {
  Box3 box;                            ///< holds the boxes of all its elements
  std::uint32_t first = 0, count = 0;  ///< of a leaf: consecutive places in the order of elements
  std::uint32_t right = 0;             ///< of an inner node; the left child follows the node
};

struct BoxTree {
  std::vector<BoxNode> nodes;        ///< the root first; none where there are no elements
  std::vector<std::uint32_t> order;  ///< the elements in the order of the leaves
};

/// Of each node, the places of its elements in the order of the leaves: from the first up to the
/// second. Children come after their parents, and a node's elements lie between those of its outer
/// leaves.
std::vector<std::pair<std::size_t, std::size_t>> element_ranges(const std::vector<BoxNode>& nodes);

/// Halves by the middle of the elements until no leaf has more than `leaf_size`.
BoxTree box_tree(const std::vector<Box3>& boxes, std::uint32_t leaf_size);

/// Walks what lies beneath some nodes of a tree of boxes, the nearer first, the left one of two
/// equally near. `bound(node)` is a lower bound of what a node holds; `beyond(bound)` says that
/// nothing so far away is of interest, and is asked again when a node's turn comes, since the
/// search may have closed in; `visit(leaf)` looks at a leaf. Not to be called from within its own
/// `visit` for the same kind of search: the stack is kept between calls. No node lies beneath
/// another one of them.
template <class Bound, class Beyond, class Visit>
void nearest_first(const std::vector<BoxNode>& nodes, std::span<const std::uint32_t> roots,
                   Bound&& bound, Beyond&& beyond, Visit&& visit) {
  struct Entry {
    std::uint32_t node;
    double bound;
  };
  thread_local std::vector<Entry> stack;
  stack.clear();
  for (const std::uint32_t root : roots) {
    const Entry entry{root, bound(nodes[root])};
    if (!beyond(entry.bound)) stack.push_back(entry);
  }
  std::sort(stack.begin(), stack.end(), [](const Entry& a, const Entry& b) {
    return a.bound != b.bound ? a.bound > b.bound : a.node > b.node;
  });
  while (!stack.empty()) {
    const Entry at = stack.back();
    stack.pop_back();
    if (beyond(at.bound)) continue;
    const BoxNode& node = nodes[at.node];
    if (node.count > 0) {
      visit(node);
      continue;
    }
    const Entry left{at.node + 1, bound(nodes[at.node + 1])};
    const Entry right{node.right, bound(nodes[node.right])};
    const bool left_first = left.bound <= right.bound;
    for (const Entry& entry : {left_first ? right : left, left_first ? left : right})
      if (!beyond(entry.bound)) stack.push_back(entry);
  }
}

/// The same of all of it.
template <class Bound, class Beyond, class Visit>
void nearest_first(const std::vector<BoxNode>& nodes, Bound&& bound, Beyond&& beyond,
                   Visit&& visit) {
  constexpr std::uint32_t kRoot = 0;
  nearest_first(nodes, std::span(&kRoot, nodes.empty() ? 0 : 1), bound, beyond, visit);
}

}  // namespace limitgauge::model
