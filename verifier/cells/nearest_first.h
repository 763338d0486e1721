#pragma once

#include <cstdint>
#include <vector>

#include "verifier/cells/box_tree.h"

namespace limitgauge::verifier {

/// Walks a tree of boxes, the nearer child first. `bound(node)` is a lower bound of what a node
/// holds; `beyond(bound)` says that nothing so far away is of interest, and is asked again when a
/// node's turn comes, since the search may have closed in; `visit(leaf)` looks at a leaf. Not to be
/// called from within its own `visit` for the same kind of search: the stack is kept between calls.
template <class Bound, class Beyond, class Visit>
void nearest_first(const std::vector<BoxNode>& nodes, Bound&& bound, Beyond&& beyond,
                   Visit&& visit) {
  struct Entry {
    std::uint32_t node;
    double bound;
  };
  thread_local std::vector<Entry> stack;
  stack.clear();
  if (!nodes.empty()) stack.push_back({0, bound(nodes[0])});
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
    stack.push_back(left_first ? right : left);
    stack.push_back(left_first ? left : right);
  }
}

}  // namespace limitgauge::verifier
