#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "model/geometry/vec3.h"

namespace limitgauge::verifier {

/// A node of a tree of boxes over elements that are given by number.
struct BoxNode {
  model::Box3 box;                     ///< holds the boxes of all its elements
  std::uint32_t first = 0, count = 0;  ///< of a leaf: consecutive places in the order of elements
  std::uint32_t right = 0;             ///< of an inner node; the left child follows the node
};

struct BoxTree {
  std::vector<BoxNode> nodes;        ///< the root first; none where there are no elements
  std::vector<std::uint32_t> order;  ///< the elements in the order of the leaves
};

/// Halves by the middle of the elements until no leaf has more than `leaf_size`.
BoxTree box_tree(const std::vector<model::Box3>& boxes, std::uint32_t leaf_size);

/// Puts that half of `order` (the smaller, where it is odd) first whose boxes' centres come first
/// along the longest side of the box around all of them; among equals by number.
void halve_by_centres(std::span<std::uint32_t> order, const std::vector<model::Box3>& boxes);

}  // namespace limitgauge::verifier
